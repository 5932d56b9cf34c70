# SPDX-License-Identifier: Apache-2.0
"""The commands of build/release, with other flags or for clang++: scripts/each, scripts/sanitize and scripts/tidy compile
some of its sources again, where the headers that the build generates are. A source includes the headers that gcc has
precompiled."""
import json
import os
import re
import subprocess

TREE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
JOBS = os.environ.get("JOBS", str(os.cpu_count()))
OF_GCC = r" (?:--param=\S+|-Wno-restrict|-Wno-maybe-uninitialized|-Wno-stringop-\w+|-Wshadow=local|-Winvalid-pch)(?= )"


def run(*command, **more):
    return subprocess.run(command, cwd=TREE, check=True, **more)


def included(match):
    """The headers that a precompiled header includes, one by one: it fits neither clang nor other flags."""
    with open(match[1], encoding="utf-8") as file:
        return " ".join(f"-include {header}" for header in re.findall(r'#include [<"](.*)[>"]', file.read()))


def for_clang(command):
    """The command of a compilation with clang in place of its compiler."""
    return re.sub(OF_GCC, "", re.sub(r"^\S+", "clang++", command))


def commands():
    """Output of build/release -> its command."""
    run("cmake", "--preset", "release", stdout=subprocess.DEVNULL)
    text = run("ninja", "-C", "build/release", "-t", "compdb", stdout=subprocess.PIPE, text=True).stdout
    return {edge["output"]: re.sub(r"-include (\S+/cmake_pch\.hxx)", included, edge["command"]) for edge in json.loads(text)}


def modules():
    """Every module but python: its interpreter is not instrumented, and its sources are not of one build."""
    with open(os.path.join(TREE, "CMakeLists.txt"), encoding="utf-8") as file:
        return re.findall(r"(?m)^jounce_declare\((?!python)(\w+)", file.read())
