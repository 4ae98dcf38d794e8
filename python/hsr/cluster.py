"""Many drawings, or one of a large scene, on many machines: what `hsr batch` and `hsr split` begin, on dask.distributed.

    python3 -m hsr.cluster LIST -o DIR --scheduler tcp://HOST:8786 [--views front,top,right,iso] ... [-- options of hsr draw]
    python3 -m hsr.cluster LIST -o DIR --workers 4 ...             on this machine

    python3 -m hsr.cluster JOB -o city.svg --workers 4 [-- options of hsr join]

What follows -- are options of hsr draw, or with --sheet of hsr sheet. JOB is a directory that `hsr split` has made: its tiles are found on
the workers, and joined here.

LIST, DIR and the models are on a file system that all workers see, and the command `hsr` is installed there. A task is the drawing of
some models, all their views; one that a worker loses is done again elsewhere, and what it had finished is not. Whatever happens, the
same command run again does what is missing. Exit status 1: some model could not be drawn, or a part of a scene is wrong.
"""

import argparse
import os
import shutil
import subprocess
import sys
import time

from . import _cluster_tiles
from .__main__ import _command

BUSY = "another hsr batch at work"


def draw_part(command, words, options, part):
    """One part of a batch, on a worker: (seconds, exit status, what it said). Raises where the command could not do its work."""
    started = time.monotonic()
    environment = {**os.environ, "LC_ALL": "C.UTF-8"}
    while True:
        ran = subprocess.run([command, "batch", *words, "--part", part, "--jobs", "1", *options], capture_output=True, text=True, env=environment, check=False)
        # Of a worker that was lost the command may still be at work: what it finishes need not be done again.
        if BUSY not in ran.stderr:
            break
        time.sleep(0.5)
    if ran.returncode not in (0, 1):
        raise RuntimeError(ran.stderr.strip().splitlines()[-1] if ran.stderr.strip() else f"hsr ended with status {ran.returncode}")
    return time.monotonic() - started, ran.returncode, ran.stderr.strip()


def run(client, words, options, models, models_in_a_task, command, report=print):
    """All parts of a batch on the workers of a client, then the manifest. Returns the exit status."""
    from distributed import as_completed

    parts = max(1, -(-models // models_in_a_task))
    began, seconds = time.monotonic(), []
    tasks = [client.submit(draw_part, command, words, options, f"{k + 1}/{parts}", retries=3, pure=False) for k in range(parts)]
    is_terminal = sys.stderr.isatty()
    for done, (_, result) in enumerate(as_completed(tasks, with_results=True), 1):
        seconds.append(result[0])
        if is_terminal:
            print(f"\rhsr: {done} of {parts} tasks", end="", file=sys.stderr, flush=True)
    if is_terminal:
        print("\r\033[K", end="", file=sys.stderr)
    workers = max(1, sum(client.nthreads().values()))
    took = time.monotonic() - began
    idle = max(0.0, 1 - sum(seconds) / (workers * took)) if took > 0 else 0.0
    last = subprocess.run([command, "batch", *words, *options], check=False)
    report(f"hsr: {parts} tasks of {workers} workers took {took:.1f} s: {sum(seconds) / parts:.2f} s each, {max(seconds):.2f} s the longest, workers idle {idle:.0%}")
    return last.returncode


def count_of_models(path):
    with open(path, encoding="utf-8", errors="surrogateescape") as lines:
        return len({line.strip() for line in lines if line.strip() and not line.startswith("#")})


def parse(arguments):
    parser = argparse.ArgumentParser(prog="python3 -m hsr.cluster", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("list", metavar="LIST|JOB", help="a file with a model to a line, or a directory of hsr split")
    parser.add_argument("-o", "--output", metavar="DIR|FILE", required=True, action="append", help="the directory of the drawings; of JOB the drawing, more than one")
    where = parser.add_mutually_exclusive_group(required=True)
    where.add_argument("--scheduler", metavar="ADDRESS", help="of a scheduler of dask.distributed that runs, tcp://HOST:PORT")
    where.add_argument("--workers", type=int, metavar="N", help="so many workers on this machine")
    parser.add_argument("--views", metavar="LIST", help="views with commas between [front,top,right,iso]")
    parser.add_argument("--format", metavar="FORMAT", help="svg, pdf, ... [svg]")
    parser.add_argument("--sheet", action="store_true", help="a drawing sheet of each model instead")
    parser.add_argument("--models", type=int, default=50, metavar="N", help="so many models to a task [50]")
    parser.add_argument("--command", metavar="PATH", help="the command hsr, as the workers have it [that of this installation]")
    words = list(sys.argv[1:] if arguments is None else arguments)
    end = words.index("--") if "--" in words else len(words)
    a = parser.parse_args(words[:end])
    a.options = words[end + 1 :]
    if a.models < 1 or (a.workers is not None and a.workers < 1):
        parser.error("found a number below 1, expected 1 or more")
    return a


def main(arguments=None):
    a = parse(arguments)
    command = a.command or _command()
    if command is None or shutil.which(command) is None:
        return refuse("the command is not installed: found neither bin/hsr beside this module nor hsr on PATH")
    if _cluster_tiles.is_job(a.list):
        return on_workers(a, tiles_of(a, command))
    if len(a.output) > 1:
        return refuse("-o: found twice, expected one directory for the drawings of a list")
    try:
        models = count_of_models(a.list)
    except OSError as error:
        return refuse(f"{a.list}: {error.strerror}, expected a file with a model to a line")
    if models == 0:
        return refuse(f"{a.list}: found no model, expected one to a line")
    words = [os.path.abspath(a.list), "-o", os.path.abspath(a.output[0])]
    words += ["--views", a.views] if a.views else []
    words += ["--format", a.format] if a.format else []
    words += ["--sheet"] if a.sheet else []
    options = ["--", *a.options] if a.options else []
    return on_workers(a, lambda client: run(client, words, options, models, a.models, command, tell))


def tiles_of(a, command):
    """What to do with a client for a job of hsr split."""
    job = os.path.abspath(a.list)
    words = [word for output in a.output for word in ("-o", output)] + a.options

    def work(client):
        try:
            tiles = _cluster_tiles.count_of_tiles(job)
        except (ValueError, KeyError, OSError):
            return refuse(f"{a.list}/job.json: found no job, expected it as hsr split has written it")
        return _cluster_tiles.run(client, command, job, tiles, words, tell)

    return work


def on_workers(a, work):
    """Does the work with a client of the workers that were asked for. Returns the exit status."""
    try:
        import distributed
    except ImportError:
        return refuse("dask.distributed is missing: in Debian it is the package python3-distributed")
    try:
        if a.scheduler:
            try:
                client = distributed.Client(a.scheduler)
            except (OSError, ValueError) as error:
                return refuse(f"--scheduler: found {a.scheduler}, expected a scheduler that answers ({str(error).splitlines()[0]})")
            with client:
                return work(client)
        with distributed.LocalCluster(n_workers=a.workers, threads_per_worker=1, dashboard_address=None, silence_logs=50) as cluster:
            with distributed.Client(cluster) as client:
                return work(client)
    except RuntimeError as error:
        return refuse(str(error).removeprefix("hsr: "))


def tell(text):
    print(text, file=sys.stderr)


def refuse(text):
    print(f"hsr: {text}", file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main())
