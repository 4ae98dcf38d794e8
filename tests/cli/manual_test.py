#!/usr/bin/env python3
"""The manual page and the completion say what --help says. Usage: manual_test.py HSR"""

import functools
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

HSR = ""


@functools.lru_cache(maxsize=None)
def output(*arguments):
    return subprocess.run(arguments, check=True, capture_output=True, text=True).stdout


def verbs():
    listed = output(HSR, "--help").split("Subcommands:\n")[1].split("\n\n")[0]
    return [line.split()[0] for line in listed.splitlines()]


def plain(page):
    """The page without the marks of roff: what a reader sees, with other blanks."""
    for mark, sign in (("\\-", "-"), ("\\(aq", "'"), ("\\:", ""), ("\\&", ""), ("\\e", "\\"), ("\\(ti", "~"), ("\\(ha", "^")):
        page = page.replace(mark, sign)
    return re.sub(r"\\f[BIR]", "", page)


def completed(*words):
    """What the script answers to a tab behind these words."""
    script = """source "$1"; shift
        COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
        _hsr
        printf '%s\\n' "${COMPREPLY[@]}" """
    with tempfile.NamedTemporaryFile("w") as file:
        file.write(output(HSR, "completion", "bash"))
        file.flush()
        answer = subprocess.run(["bash", "--norc", "-euc", script, "bash", file.name, "hsr", *words], check=True,
                                capture_output=True, text=True)
        return answer.stdout.split()


class Manual(unittest.TestCase):
    def setUp(self):
        self.page = output(HSR, "manual")
        self.sections = dict(re.findall(r"^\.SH (.*)\n((?:(?!\.SH ).*\n)*)", plain(self.page), re.M))

    @unittest.skipUnless(shutil.which("groff"), "without groff")
    def test_roff_has_nothing_to_warn_of(self):
        found = subprocess.run(["groff", "-man", "-ww", "-rLL=80n", "-Tascii"], input=self.page, capture_output=True, text=True)
        self.assertEqual((found.returncode, found.stderr), (0, ""))

    @unittest.skipUnless(shutil.which("man"), "without man")
    def test_man_has_nothing_to_warn_of(self):
        with tempfile.NamedTemporaryFile("w", suffix=".1") as file:
            file.write(self.page)
            file.flush()
            found = subprocess.run(["man", "--warnings=w", "-l", file.name], capture_output=True, text=True,
                                   env={**os.environ, "MANWIDTH": "80", "LC_ALL": "C.UTF-8", "MANPAGER": "cat"})
        self.assertEqual((found.returncode, found.stderr), (0, ""))
        self.assertIn("hsr - what is visible, exactly", found.stdout)

    def test_every_option_value_and_help_text_is_in_the_section_of_its_verb(self):
        self.assertGreater(len(verbs()), 5)
        for verb in verbs():
            text, section = output(HSR, verb, "--help"), self.sections["HSR " + verb.upper()]
            options = re.findall(r"^  ((?:-\w,)?--[\w-]+)(?: (NAME=\S+|[A-Z]\S*?)(?::\{(\S+)\})?(?:=(\S+))?)?(?:  | \.\.\.| REQ|$)", text, re.M)
            self.assertEqual(len(options), len(re.findall(r"^  -", text, re.M)))
            for names, kind, _, _ in options:
                heading = names.replace(",", ", ") + (" " + kind if kind else "")
                self.assertRegex(section, r"(?m)(^|, )" + re.escape(heading) + r"($|[,:])", verb)
            told = " ".join(self.sections.values())
            for _, _, values, default in options:
                self.assertIn("Values: " + values.replace(",", ", ") + "." if values else "", told)
                self.assertIn("Default: " + default + "." if default else "", told)
            for line in re.findall(r"^(?:  -.{25}  | {30})(\S.*)", text, re.M):
                self.assertIn(line, told)

    def test_every_line_below_the_options_is_there(self):
        for verb in verbs():
            for line in output(HSR, verb, "--help").split("\nExamples:\n")[1].splitlines():
                for part in re.split(r"  +", line.strip()):
                    self.assertIn(part, self.sections["EXAMPLES"] + self.sections["HSR " + verb.upper()])

    def test_exit_status_and_version_are_there(self):
        status = re.search(r"^Exit status: (.*)", output(HSR, "--help"), re.M).group(1)
        self.assertEqual(self.sections["EXIT STATUS"].strip(), status)
        self.assertIn('"' + output(HSR, "--version").strip() + '"', plain(self.page))

    def test_help_does_not_name_the_verbs_of_the_build(self):
        self.assertNotIn("manual", output(HSR, "--help"))
        self.assertNotIn("completion", output(HSR, "--help"))
        refused = subprocess.run([HSR, "completion", "fish"], capture_output=True, text=True)
        self.assertEqual((refused.returncode, refused.stdout, refused.stderr.count("\n")), (2, "", 1))


@unittest.skipUnless(shutil.which("bash"), "without bash")
class Completion(unittest.TestCase):
    def test_bash_can_read_it(self):
        subprocess.run(["bash", "-n"], input=output(HSR, "completion", "bash"), check=True, text=True)

    def test_verbs(self):
        self.assertEqual(completed("dr"), ["draw"])
        self.assertEqual(completed(""), verbs() + ["-h", "--help", "--version"])
        self.assertEqual(completed("manual", "--"), [])

    def test_all_options_of_each_verb(self):
        self.assertEqual(sorted(completed("draw", "--hid")), ["--hidden", "--hide"])
        for verb in verbs():
            options = re.findall(r"^  (?:(-\w),)?(--[\w-]+)", output(HSR, verb, "--help"), re.M)
            self.assertEqual(sorted(completed(verb, "-")), sorted(name for pair in options for name in pair if name))

    def test_all_values_of_each_option(self):
        self.assertEqual(completed("draw", "--hidden", ""), ["none", "dashed", "solid"])
        self.assertEqual(completed("draw", "--hidden", "=", "d"), ["dashed"])
        self.assertEqual(completed("draw", "--hidden", "="), ["none", "dashed", "solid"])
        for verb in verbs():
            for name, values in re.findall(r"^  (--[\w-]+) [A-Z]+:\{(\S+)\}", output(HSR, verb, "--help"), re.M):
                self.assertEqual(completed(verb, name, ""), values.split(","))

    def test_what_is_offered_and_the_last_of_a_list(self):
        self.assertEqual(completed("info", "--view", "b"), ["back", "bottom"])
        self.assertEqual(completed("order", "--edges", "outline,sh"), ["outline,sharp"])
        self.assertEqual(completed("stability", "--family", "gap,u"), ["gap,ulp"])
        self.assertEqual(completed("draw", "--fov", ""), [])

    def test_files_and_directories(self):
        with tempfile.TemporaryDirectory() as directory:
            os.mkdir(directory + "/parts")
            open(directory + "/part.stl", "w").close()
            both = sorted([directory + "/part.stl", directory + "/parts"])
            self.assertEqual(sorted(completed("draw", directory + "/p")), both)
            self.assertEqual(sorted(completed("draw", "a.obj", "-o", directory + "/p")), both)
            self.assertEqual(completed("compare", "a.obj", "-o", directory + "/p"), [directory + "/parts"])
            self.assertEqual(completed("stability", directory + "/p"), [])


if __name__ == "__main__":
    HSR = os.path.abspath(sys.argv.pop(1))
    unittest.main()
