#!/usr/bin/env python3
"""Whether docs/conventions.md and the tests say the same: every rule (**H3**) has a test that bears its number as a tag ([H3]),
and every number that a test bears is a rule. Tests that a run of ctest leaves out ([long], [.]) do not count. Standard library
only."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
RULE = r"[A-Z][1-9][0-9]?"

# Rules that no test shows, each with the reason. A rule with a test is not open any more: then the script fails, too.
OPEN = {}

STRING = r'"(?:[^"\\]|\\.)*"'
CASE = re.compile(rf"\b(?:TEMPLATE_)?TEST_CASE\(\s*((?:{STRING}\s*)+),\s*((?:{STRING}\s*)+)[,)]")


def rules():
    """The rules of the page in its order; a letter's rules are numbered 1, 2, 3 ..."""
    text = (ROOT / "docs" / "conventions.md").read_text()
    found = re.findall(rf"^(?:\s*\* |\| )\*\*({RULE})\*\*", text, re.M)
    problems = []
    last = {}
    for rule in found:
        letter, number = rule[0], int(rule[1:])
        if number != last.get(letter, 0) + 1:
            problems.append(f"docs/conventions.md: rule {rule} does not follow {letter}{last.get(letter, 0)}")
        last[letter] = number
    if len(found) < 100:
        problems.append(f"docs/conventions.md: only {len(found)} rules found: are they marked as they were?")
    return found, problems


def tags():
    """Rule -> names of the tests that bear it."""
    by_rule = {}
    cases = 0
    for file in sorted((ROOT / "tests").rglob("*.cpp")):
        code = re.sub(r"^\s*//.*$", "", file.read_text(), flags=re.M)
        for name, tag_text in CASE.findall(code):
            cases += 1
            all_tags = re.findall(r"\[([^\]]+)\]", tag_text)
            if "long" in all_tags or any(tag.startswith(".") for tag in all_tags):
                continue
            for tag in all_tags:
                if re.fullmatch(RULE, tag):
                    by_rule.setdefault(tag, []).append(f"{file.relative_to(ROOT)}: {name.strip()}")
    return by_rule, cases


def main():
    known, problems = rules()
    by_rule, cases = tags()
    for rule in known:
        if rule not in by_rule and rule not in OPEN:
            problems.append(f"rule {rule} has no test")
        if rule in by_rule and rule in OPEN:
            problems.append(f"rule {rule} is listed as open and has a test: {by_rule[rule][0]}")
    for rule in sorted(set(by_rule) - set(known)):
        problems.append(f"{by_rule[rule][0]} names {rule}, which is no rule of docs/conventions.md")
    for rule in sorted(set(OPEN) - set(known)):
        problems.append(f"the open rule {rule} is no rule of docs/conventions.md")
    for problem in problems:
        print(problem)
    tested = len([rule for rule in known if rule in by_rule])
    print(f"{len(known)} rules, {tested} of them in {cases} test cases, {len(OPEN)} open, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
