"""`python3 -m hsr` is the command `hsr`."""

import os
import pathlib
import shutil
import sys


def _command():
    """The command of this installation or build, else that of PATH."""
    for above in pathlib.Path(__file__).resolve().parents[1:5]:
        command = above / "bin" / "hsr"
        if os.access(command, os.X_OK) and command.is_file():
            return str(command)
    return shutil.which("hsr")


def main():
    command = _command()
    if command is None:
        sys.exit("hsr: the command is not installed: found neither bin/hsr beside this module nor hsr on PATH")
    os.execv(command, [command, *sys.argv[1:]])


if __name__ == "__main__":
    main()
