#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""claims.py PAGE SOURCE_DIR: every test that a page names is there. A name is what ctest prints, in backticks:
`axis: Suite.Test` of tests/axis, or the NAME of an add_test. In a table with the columns "example", "page" and "tests",
each row has all three. Exit status 1 names what is missing."""
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
    return any(macro.search(file.read_text()) for file in folder.rglob("*.cpp"))


def incomplete(text):
    """Rows of a table of examples, pages and tests in which one of the three is missing."""
    heads, found = None, []
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")] if line.startswith("| ") else None
        if cells is None:
            heads = heads if line.startswith("|-") else None
        elif heads is None:
            heads = {name: k for k, name in enumerate(cells)}
        elif {"example", "page", "tests"} <= heads.keys():
            example, where, tests = (cells[heads[name]] for name in ("example", "page", "tests"))
            if "](../../examples/" not in example or "](" not in where or "`" not in tests:
                found.append(cells[0])
    return found


text = page.read_text()
modules = {folder.name for folder in (root / "tests").iterdir() if folder.is_dir()} | folders.keys()
named = [name for name in re.findall(r"`([^`\n]+)`", text)
         if (module := re.match(r"(\w+)\b[^:`]*: ", name)) and module[1] in modules]
missing = [name for name in named if not is_there(name)]
for name in missing:
    print(f"{page.name}: there is no test {name}")
rows = incomplete(text)
for row in rows:
    print(f"{page.name}: the row {row} needs an example, a page and a test")
print(f"{len(named)} tests named")
sys.exit(bool(missing or rows) or len(named) < 20)
