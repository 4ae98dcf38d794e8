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
                for _ in range(4):
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
