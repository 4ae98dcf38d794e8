"""What of a wheel setuptools cannot know: CMake builds the core of the module and the command. pyproject.toml has the rest.

CMAKE_ARGS in the environment is handed to CMake. What is made is in build/wheel and build/setuptools.
"""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.install_scripts import install_scripts

ROOT = pathlib.Path(__file__).resolve().parent
MADE = ROOT / "build" / "setuptools"
CMAKE = ROOT / "build" / "wheel"


class BuildWithCMake(build_ext):
    def build_extension(self, ext):
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "HSR_PYTHON": "ON",
            "HSR_PYTHON_EXECUTABLE": sys.executable,
            "HSR_TESTS": "OFF",
            "HSR_BENCH": "OFF",
            "HSR_EXAMPLES": "OFF",
            "HSR_STEP": "OFF",
            "HSR_3MF": "OFF",
        }
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        given = [f"-D{name}={value}" for name, value in options.items()] + shlex.split(os.environ.get("CMAKE_ARGS", ""))
        subprocess.run(["cmake", "-S", str(ROOT), "-B", str(CMAKE), *generator, *given], check=True)
        jobs = [] if "CMAKE_BUILD_PARALLEL_LEVEL" in os.environ else ["--parallel", str(os.cpu_count() or 1)]
        subprocess.run(["cmake", "--build", str(CMAKE), *jobs, "--target", "hsr_python", "hsr_command"], check=True)
        target = pathlib.Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        (core,) = (CMAKE / "python" / "hsr").glob(f"_core.*{target.suffix}")
        shutil.copy2(core, target)


class InstallCommand(install_scripts):
    """The command is no script: it is copied as it is."""

    def run(self):
        os.makedirs(self.install_dir, exist_ok=True)
        self.outfiles = [shutil.copy2(CMAKE / "bin" / "hsr", self.install_dir)]


MADE.mkdir(parents=True, exist_ok=True)
setup(
    version=re.search(r"project\(hsr VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1],
    ext_modules=[Extension("hsr._core", sources=[])],
    cmdclass={"build_ext": BuildWithCMake, "install_scripts": InstallCommand},
    options={"build": {"build_base": str(MADE)}, "egg_info": {"egg_base": str(MADE)}},
)
