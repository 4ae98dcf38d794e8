"""One scene in tiles on the workers of a client of dask.distributed: what `hsr split` has made, by `hsr tile`, then `hsr join`."""

import json
import os
import subprocess
import sys
import time


def is_job(path):
    return os.path.isfile(os.path.join(path, "job.json"))


def count_of_tiles(job):
    """Raises ValueError where the job is not readable."""
    with open(os.path.join(job, "job.json"), encoding="utf-8", errors="surrogateescape") as file:
        return len(json.load(file)["tiles"])


def do_tile(command, job, number):
    """One tile, on a worker: (number, seconds, bytes read, bytes written). Raises where the command could not do it."""
    started = time.monotonic()
    environment = {**os.environ, "LC_ALL": "C.UTF-8"}
    ran = subprocess.run([command, "tile", job, str(number), "-q", "--threads", "1"], capture_output=True, text=True, env=environment, check=False)
    if ran.returncode != 0:
        raise RuntimeError(ran.stderr.strip().splitlines()[-1] if ran.stderr.strip() else f"hsr tile {number} ended with status {ran.returncode}")
    size = {name: os.path.getsize(os.path.join(job, f"{name}-{number}")) for name in ("tile", "part")}
    return number, time.monotonic() - started, size["tile"], size["part"]


def run(client, command, job, tiles, join_words, report=print):
    """All tiles on the workers of a client, then the drawing. Returns the exit status of `hsr join`.

    A task that a worker loses is done again elsewhere, and a tile that is done is left as it is, so that nothing is done twice that
    need not be. Raises RuntimeError with what the command said where a tile cannot be done.
    """
    from distributed import as_completed

    began, done = time.monotonic(), []
    tasks = [client.submit(do_tile, command, job, number, retries=3, pure=False) for number in range(1, tiles + 1)]
    is_terminal = sys.stderr.isatty()
    for _, result in as_completed(tasks, with_results=True):
        done.append(result)
        if is_terminal:
            bar = "#" * (30 * len(done) // tiles)
            print(f"\rhsr: [{bar:30}] {len(done)} of {tiles} tiles", end="", file=sys.stderr, flush=True)
    if is_terminal:
        print("\r\033[K", end="", file=sys.stderr)
    workers = max(1, sum(client.nthreads().values()))
    took, seconds = time.monotonic() - began, sum(result[1] for result in done)
    worst = max(done, key=lambda result: result[1])
    idle = max(0.0, 1 - seconds / (workers * took)) if took > 0 else 0.0
    read, written = sum(result[2] for result in done) / 1e6, sum(result[3] for result in done) / 1e6
    report(
        f"hsr: {tiles} tiles of {workers} workers took {took:.1f} s: {seconds / tiles:.2f} s each, {worst[1]:.2f} s the longest (tile {worst[0]}), "
        f"workers idle {idle:.0%}, {read:.1f} MB read, {written:.1f} MB written"
    )
    return subprocess.run([command, "join", job, *join_words], check=False).returncode
