"""hsr.cluster: a batch on workers of dask.distributed, undisturbed and with workers that are killed. HSR_COMMAND is the command."""

import importlib.util
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import scenes

COMMAND = os.environ.get("HSR_COMMAND", "hsr")
HAS_DASK = importlib.util.find_spec("distributed") is not None


def drawings(directory):
    return {str(path.relative_to(directory)): path.read_bytes() for path in sorted(pathlib.Path(directory).rglob("*.svg")) if not path.name.startswith(".")}


def without_seconds(manifest):
    rows = [line.split(",") for line in manifest.read_text().splitlines()]
    return [row[:4] + row[5:] for row in rows]


@unittest.skipUnless(HAS_DASK, "dask.distributed is not installed")
class Clusters(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.place.name)
        models = []
        for k in range(24):
            path = self.folder / f"soup{k}.obj"
            scenes.write_obj(str(path), scenes.soup(k, 25, 3))
            models.append(str(path))
        (self.folder / "bad.obj").write_text("v 0 0 0\nf 1 2 3\n")
        models.append(str(self.folder / "bad.obj"))
        self.list = self.folder / "list.txt"
        self.list.write_text("\n".join(models) + "\n")
        self.options = ["--hidden", "dashed"]
        words = [COMMAND, "batch", str(self.list), "-o", str(self.folder / "alone"), "--views", "iso,top", "-q", "--", *self.options]
        self.assertEqual(subprocess.run(words, check=False).returncode, 1)

    def tearDown(self):
        self.place.cleanup()

    def compare(self, out):
        self.assertEqual(drawings(out), drawings(self.folder / "alone"))
        self.assertEqual(without_seconds(out / "manifest.csv"), without_seconds(self.folder / "alone" / "manifest.csv"))

    def test_the_batch_of_one_machine(self):
        out = self.folder / "out"
        words = [sys.executable, "-m", "hsr.cluster", str(self.list), "-o", str(out), "--workers", "3", "--models", "4", "--views", "iso,top", "--command", COMMAND, "--", *self.options]
        ran = subprocess.run(words, capture_output=True, text=True, check=False)
        self.assertEqual(ran.returncode, 1, ran.stderr)
        self.assertRegex(ran.stderr, r"hsr: 7 tasks of 3 workers took [0-9.]+ s: ")
        self.assertIn("50 drawings: 0 made now, 48 as they were, 2 failed", ran.stderr)
        self.compare(out)
        again = subprocess.run(words, capture_output=True, text=True, check=False)
        self.assertIn("50 drawings: 0 made now", again.stderr)

    def test_workers_that_are_killed(self):
        import distributed

        from hsr import cluster

        out, rng = self.folder / "killed", random.Random(7)
        with distributed.LocalCluster(n_workers=3, threads_per_worker=1, dashboard_address=None, silence_logs=50) as local:
            with distributed.Client(local) as client:
                killed = []

                def kill():
                    for _ in range(2):
                        time.sleep(rng.uniform(0.2, 0.6))
                        workers = [nanny.process.process.pid for nanny in local.workers.values() if nanny.process is not None and nanny.process.process is not None]
                        if workers:
                            killed.append(rng.choice(workers))
                            os.kill(killed[-1], 9)

                killer = threading.Thread(target=kill)
                killer.start()
                words = [str(self.list), "-o", str(out), "--views", "iso,top"]
                status = cluster.run(client, words, ["--", *self.options], 25, 2, COMMAND, lambda text: None)
                killer.join()
        self.assertEqual(status, 1)
        self.assertTrue(killed)
        self.compare(out)

    def test_refused(self):
        for words, text in (
            (["none.txt", "-o", "x", "--workers", "1"], "none.txt: No such file"),
            ([os.devnull, "-o", "x", "--workers", "1"], "found no model"),
            ([str(self.list), "-o", "x"], "--scheduler --workers is required"),
            ([str(self.list), "-o", "x", "--workers", "0"], "found a number below 1"),
            ([str(self.list), "-o", str(self.list), "--workers", "1", "--command", COMMAND], "cannot be made a directory"),
            ([str(self.list), "-o", "x", "--scheduler", "nowhere://1", "--command", COMMAND], "--scheduler: found nowhere://1"),
        ):
            with self.subTest(words=words):
                ran = subprocess.run([sys.executable, "-m", "hsr.cluster", *words], capture_output=True, text=True, check=False)
                self.assertEqual(ran.returncode, 2)
                self.assertIn(text, ran.stderr)
                self.assertNotIn("Traceback", ran.stderr)


if __name__ == "__main__":
    unittest.main()
