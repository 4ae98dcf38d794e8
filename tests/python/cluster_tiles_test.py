"""hsr.cluster with a job of hsr split: undisturbed, with workers that are killed, and with a scheduler that is. HSR_COMMAND is the command."""

import importlib.util
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import scenes

COMMAND = os.environ.get("HSR_COMMAND", "hsr")
HAS_DASK = importlib.util.find_spec("distributed") is not None
TILES = 12


@unittest.skipUnless(HAS_DASK, "dask.distributed is not installed")
class ClustersOfTiles(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.place.name)
        self.model = self.folder / "soup.obj"
        scenes.write_obj(str(self.model), scenes.soup(5, 400, 9))
        self.job = self.folder / "job"
        self.hsr("split", self.model, "-q", "-o", self.job, "--tiles", TILES, "--view", "top")
        self.hsr("draw", self.model, "-q", "-o", self.folder / "one.svg", "-o", self.folder / "one.pdf", "--view", "top", "--page", "A2")

    def tearDown(self):
        self.place.cleanup()

    def hsr(self, *words):
        ran = subprocess.run([COMMAND, *map(str, words)], capture_output=True, text=True, check=False)
        self.assertEqual(ran.returncode, 0, ran.stderr)

    def cluster(self, *words):
        return subprocess.run([sys.executable, "-m", "hsr.cluster", str(self.job), *map(str, words), "--command", COMMAND], capture_output=True, text=True, check=False)

    def remove_parts(self):
        for part in self.job.glob("part-*"):
            part.unlink()

    def compare(self, *formats):
        for f in formats:
            self.assertEqual((self.folder / f"many.{f}").read_bytes(), (self.folder / f"one.{f}").read_bytes())

    def test_the_drawing_of_one_machine(self):
        words = [sys.executable, "-m", "hsr.cluster", str(self.job), "-o", str(self.folder / "many.svg"), "-o", str(self.folder / "many.pdf"), "--workers", "2", "--command", COMMAND, "--", "--page", "A2"]
        ran = subprocess.run(words, capture_output=True, text=True, check=False)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertRegex(ran.stderr, rf"hsr: {TILES} tiles of 2 workers took [0-9.]+ s: [0-9.]+ s each, [0-9.]+ s the longest \(tile [0-9]+\), workers idle [0-9]+%, [0-9.]+ MB read, [0-9.]+ MB written")
        self.compare("svg", "pdf")

    def test_workers_that_are_killed(self):
        import distributed

        from hsr import _cluster_tiles

        rng = random.Random(3)
        with distributed.LocalCluster(n_workers=3, threads_per_worker=1, dashboard_address=None, silence_logs=50) as local:
            with distributed.Client(local) as client:
                for _ in range(20):
                    self.remove_parts()
                    killed = []

                    def kill():
                        time.sleep(rng.uniform(0.0, 0.2))
                        workers = [nanny.process.process.pid for nanny in local.workers.values() if nanny.process is not None and nanny.process.process is not None]
                        if workers:
                            killed.append(rng.choice(workers))
                            os.kill(killed[-1], signal.SIGKILL)

                    killer = threading.Thread(target=kill)
                    killer.start()
                    words = ["-q", "-o", str(self.folder / "many.svg"), "--page", "A2"]
                    self.assertEqual(_cluster_tiles.run(client, COMMAND, str(self.job), TILES, words, lambda text: None), 0)
                    killer.join()
                    self.assertTrue(killed)
                    self.compare("svg")

    def start_scheduler(self, port):
        words = ["-c", "from distributed.cli.dask_scheduler import main; main()"]
        scheduler = subprocess.Popen([sys.executable, *words, "--port", str(port), "--no-dashboard", "--host", "127.0.0.1"], stderr=subprocess.PIPE, text=True)
        for line in scheduler.stderr:
            found = re.search(r"tcp://[0-9.]+:[0-9]+", line)
            if found:
                threading.Thread(target=scheduler.stderr.read, daemon=True).start()
                return scheduler, found[0]
        self.fail("the scheduler did not start")

    def start_worker(self, address):
        words = ["-c", "from distributed.cli.dask_worker import main; main()", address, "--nthreads", "1", "--no-dashboard", "--local-directory", str(self.folder)]
        return subprocess.Popen([sys.executable, *words], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)

    def test_a_scheduler_that_is_killed(self):
        for kill in (True, False):
            scheduler, address = self.start_scheduler(0)
            worker = self.start_worker(address)
            try:
                self.remove_parts() if kill else None
                words = [sys.executable, "-m", "hsr.cluster", str(self.job), "-o", str(self.folder / "many.svg"), "--scheduler", address, "--command", COMMAND, "--", "-q", "--page", "A2"]
                at_work = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
                if kill:
                    while not list(self.job.glob("part-*")):
                        time.sleep(0.01)
                    scheduler.kill()
                    time.sleep(0.5)
                    at_work.kill()  # it would wait for the scheduler to come back
                    at_work.communicate()
                    self.assertFalse((self.folder / "many.svg").exists())
                else:
                    _, said = at_work.communicate(timeout=120)
                    self.assertEqual(at_work.returncode, 0, said)
                    self.compare("svg")
            finally:
                scheduler.kill()
                os.killpg(worker.pid, signal.SIGKILL)
                scheduler.wait()
                worker.wait()

    def test_parts_that_are_wrong_are_done_again(self):
        """Truncated, of another tile, of another job: hsr join names the file, and the cluster mends it."""
        self.hsr("tile", self.job, "-q", *range(1, TILES + 1))
        other = self.folder / "other"
        self.hsr("split", self.model, "-q", "-o", other, "--tiles", TILES, "--view", "front")
        self.hsr("tile", other, "-q", 7)
        part = self.job / "part-7"
        whole = part.read_bytes()
        for wrong, said in ((whole[: len(whole) // 2], "not whole"), ((self.job / "part-2").read_bytes(), "of tile 2"), ((other / "part-7").read_bytes(), "of another job")):
            part.write_bytes(wrong)
            ran = subprocess.run([COMMAND, "join", str(self.job), "-o", str(self.folder / "many.svg")], capture_output=True, text=True, check=False)
            self.assertEqual(ran.returncode, 1)
            self.assertIn(f"part-7: {said}", ran.stderr)
            self.assertFalse((self.folder / "many.svg").exists())
        ran = self.cluster("-o", self.folder / "many.svg", "-o", self.folder / "many.pdf", "--workers", 2)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertEqual(part.read_bytes(), whole)

    def test_a_full_disk(self):
        limited = self.folder / "limited"
        limited.write_text(f'#!/bin/bash\nulimit -f 1\nexec "{COMMAND}" "$@"\n')
        limited.chmod(0o755)
        words = [sys.executable, "-m", "hsr.cluster", str(self.job), "-o", str(self.folder / "many.svg"), "--workers", "1", "--command", str(limited)]
        ran = subprocess.run(words, capture_output=True, text=True, check=False)
        self.assertEqual(ran.returncode, 2)
        self.assertRegex(ran.stderr, "part-[0-9]+: cannot be written")
        self.assertNotIn("Traceback", ran.stderr)
        self.assertFalse((self.folder / "many.svg").exists())
        self.assertEqual([p.name for p in self.job.iterdir() if not re.fullmatch(r"job\.json|(tile|part)-[0-9]+", p.name)], [])

    def test_two_at_once(self):
        words = [sys.executable, "-m", "hsr.cluster", str(self.job), "-o", str(self.folder / "many.svg"), "--workers", "2", "--command", COMMAND, "--", "-q", "--page", "A2"]
        both = [subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) for _ in range(2)]
        for one in both:
            _, said = one.communicate()
            self.assertEqual(one.returncode, 0, said)
        self.compare("svg")

    def test_what_is_wrong_is_said(self):
        (self.job / "tile-3").write_bytes(b"nothing")
        ran = self.cluster("-o", self.folder / "many.svg", "--workers", 1)
        self.assertEqual(ran.returncode, 2)
        self.assertIn("tile-3: found other bytes", ran.stderr)
        self.assertNotIn("Traceback", ran.stderr)
        (self.job / "job.json").write_text("{}")
        ran = self.cluster("-o", self.folder / "many.svg", "--workers", 1)
        self.assertEqual(ran.returncode, 2)
        self.assertIn("job.json: found no job", ran.stderr)


if __name__ == "__main__":
    unittest.main()
