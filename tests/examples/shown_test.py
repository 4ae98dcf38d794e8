#!/usr/bin/env python3
"""The C++ program of the README is examples/visible_lines.cpp, word for word, and each example stands in docs/examples.md with
what it prints."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
wrong = []

program = (ROOT / "examples" / "visible_lines.cpp").read_text(encoding="utf-8")
shown = re.findall(r"```cpp\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.S)
code = program.split("\n", 1)[1]  # the first line says what it prints; the README says so in its text
if shown != [code]:
    wrong.append("README.md: its program is not examples/visible_lines.cpp without the first line")

page = (ROOT / "docs" / "examples.md").read_text(encoding="utf-8")
for example in sorted((ROOT / "examples").glob("*.cpp")):
    if f"(../examples/{example.name})" not in page:
        wrong.append(f"docs/examples.md: {example.name} is not in it")
    text = example.read_text(encoding="utf-8")
    expected = ROOT / "tests" / "examples" / "expected" / (example.stem + ".txt")
    if expected.exists():
        if len(text.splitlines()) >= 40:
            wrong.append(f"{example.name}: 40 lines or more")
        if not text.startswith("// "):
            wrong.append(f"{example.name}: no comment on what it prints")

for line in wrong:
    print(line, file=sys.stderr)
sys.exit(1 if wrong else 0)
