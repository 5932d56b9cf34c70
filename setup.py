# SPDX-License-Identifier: Apache-2.0
"""Builds the Python package with CMake, for pip. The environment variable JOUNCE_BUILD names a configured build folder to
use instead of a new one."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

import setuptools
from setuptools.command.build_ext import build_ext

root = pathlib.Path(__file__).parent
version = re.search(r"project\(jounce VERSION (\S+)", (root / "CMakeLists.txt").read_text())


class CMakeBuild(build_ext):
    """Builds the target _jounce, and installs the component `python` into the wheel."""

    def run(self):
        target = pathlib.Path(self.build_lib).absolute()
        build = pathlib.Path(os.environ.get("JOUNCE_BUILD") or pathlib.Path(self.build_temp) / "cmake").absolute()
        if "JOUNCE_BUILD" not in os.environ:
            self.configure(build)
        subprocess.run(["cmake", "--build", build, "--target", "_jounce"], check=True)
        subprocess.run(["cmake", "--install", build, "--component", "python", "--strip", "--prefix", target / "installed"],
                       check=True)
        next((target / "installed").glob("lib/python3*/dist-packages/jounce")).replace(target / "jounce")
        shutil.rmtree(target / "installed")

    def configure(self, build):
        subprocess.run(["cmake", "-S", root, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        "-DJOUNCE_MODULES=python", "-DJOUNCE_TESTS=OFF", "-DJOUNCE_BENCH=OFF", "-DJOUNCE_WITH_PYTHON=ON",
                        f"-DJOUNCE_PYTHON={sys.executable}"], check=True)

    def get_outputs(self):
        return []


setuptools.setup(version=version[1], packages=[], cmdclass={"build_ext": CMakeBuild},
                 ext_modules=[setuptools.Extension("jounce._jounce", [])])
