#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""claims.py PAGE SOURCE_DIR: every test that a page names is there. A name is what ctest prints, in backticks:
`axis: Suite.Test` of tests/axis, or the NAME of an add_test. Exit status 1 names those that are missing."""
import pathlib
import re
import sys

page, root = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
folders = {"plays": "cli"}  # a test program in another module's folder
scripts = "\n".join(file.read_text() for file in root.glob("tests/**/CMakeLists.txt"))


def is_there(name):
    module, _, test = name.partition(": ")
    gtest = re.fullmatch(r"(\w+)\.(\w+)", test)
    if not gtest:
        first, _, last = name.rpartition(", ")  # test of a foreach: "cli: survives, ${what}"
        looped = f"{first}, ${{what}}" in scripts and re.search(rf"foreach\(what [^)]*\b{last}\b", scripts)
        return f'NAME "{name}"' in scripts or bool(looped)
    folder = root / "tests" / folders.get(module, module)
    macro = re.compile(rf"TEST(_F|_P)?\({gtest[1]}, {gtest[2]}\)")
    return any(macro.search(file.read_text()) for file in folder.glob("*.cpp"))


named = [name for name in re.findall(r"`([^`\n]+)`", page.read_text())
         if re.match(r"(stream|axis|drive|executor|web|cli|plays)\b[^:`]*: ", name)]
missing = [name for name in named if not is_there(name)]
for name in missing:
    print(f"{page.name}: there is no test {name}")
print(f"{len(named)} tests named")
sys.exit(bool(missing) or len(named) < 20)
