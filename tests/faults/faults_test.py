#!/usr/bin/env python3
"""Lets each call of the command to the system fail in turn, and some of its allocations, and looks for what must not be: a crash, another
exit status than 0 and 2, more than one line, half a file, a file of several without the others, a lost input, a temporary file.

    faults_test.py HSR FAULTS      the command, and the library that lets calls fail
"""

import os
import pathlib
import subprocess
import sys
import tempfile

HSR, FAULTS = sys.argv[1:3]
MODEL = """v 0 0 0
v 4 0 0
v 4 3 0
v 0 3 0
v 0 0 2
v 4 0 2
v 4 3 2
v 0 3 2
v 1 1 -1
v 2 1 5
v 2 2 5
f 4 3 2 1
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
f 5 6 7 8
f 9 10 11
"""
COMMANDS = (
    ["draw", "m.obj", "-o", "o.svg", "-o", "o.png", "-o", "o.pdf", "-o", "o.json", "--hidden", "dashed", "--fill", "--threads", "1", "-q"],
    ["order", "m.obj", "-o", "o.json", "-o", "o.svg", "--threads", "1", "-q"],
    ["sheet", "m.obj", "-o", "o.pdf", "-o", "o.dxf", "--section", "x=2", "--threads", "1", "-q"],
)
OLD = b"what was there before\n"


class Faults:
    def __init__(self, folder, command):
        self.folder, self.command = folder, command
        self.outputs = [folder / word for word in command if word.startswith("o.")]
        (folder / "m.obj").write_text(MODEL)

    def run(self, fault):
        for path in self.outputs:
            path.write_bytes(OLD)
        count = self.folder / "count"
        count.unlink(missing_ok=True)
        environment = {**os.environ, "LD_PRELOAD": FAULTS, "HSR_FAULT": fault, "HSR_FAULT_COUNT": str(count)}
        ran = subprocess.run([HSR, *self.command], cwd=self.folder, env=environment, capture_output=True, text=True, check=False, timeout=60)
        return ran, int(count.read_text()) if count.exists() else 0

    def trouble(self, kind, ran, good):
        """What is wrong after a run, or nothing."""
        contents = {path: path.read_bytes() for path in self.outputs}
        if ran.returncode not in (0, 2):
            return f"exit status {ran.returncode}: {ran.stderr.strip()[-100:]}"
        if ran.stderr.count("\n") > 1:
            return f"more than one line: {ran.stderr[:200]}"
        if ran.returncode == 0 and contents != good:
            return "status 0, and a file that is not what it should be"
        if any(bytes not in (OLD, good[path]) for path, bytes in contents.items()):
            return "half a file"
        # A name that cannot be given: those before it have theirs, as there is no way back.
        if ran.returncode == 2 and kind != "rename" and any(bytes != OLD for bytes in contents.values()):
            return "some of the files without the others"
        if (self.folder / "m.obj").read_text() != MODEL:
            return "the model is not what it was"
        left = [path.name for path in self.folder.iterdir() if path.name not in {"m.obj", "count"} | {o.name for o in self.outputs}]
        return f"left behind: {left}" if left else None

    def sweep(self, kind):
        ran, calls = self.run(f"{kind} 0")
        assert ran.returncode == 0, ran.stderr
        good = {path: path.read_bytes() for path in self.outputs}
        wanted = set(range(1, min(calls, 20) + 1)) | set(range(max(1, calls - 20), calls + 1)) | set(range(1, calls + 1, max(1, calls // 60)))
        problems = 0
        for k in sorted(wanted):
            ran, _ = self.run(f"{kind} {k}")
            trouble = self.trouble(kind, ran, good)
            if trouble:
                problems += 1
                print(f"{self.command[0]}: {kind} {k} of {calls}: {trouble}")
        return len(wanted), problems


def main():
    tried = problems = 0
    for command in COMMANDS:
        for kind in ("write", "open", "close", "rename", "read", "memory"):
            with tempfile.TemporaryDirectory() as folder:
                more, wrong = Faults(pathlib.Path(folder), command).sweep(kind)
                tried, problems = tried + more, problems + wrong
    print(f"{tried} calls failed in turn, {problems} problems")
    return 1 if problems or tried < 300 else 0


if __name__ == "__main__":
    sys.exit(main())
