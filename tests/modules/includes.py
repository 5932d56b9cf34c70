#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds the includes against the modules that CMakeLists.txt declares.

    includes.py ROOT

A module includes the modules that its jounce_declare() names, each at least once, and no other. CMake accepts only modules
that are declared before it, so there is no circle. Another module's `src` folder is private, except for tests and benchmarks. No
installed header (those of the modules in jounce_api()) includes a header that is not installed: one from a `detail` folder, or one of
another module. The private names of a module are in its own namespace, jounce::MODULE_detail:
two modules that use one namespace for private types can define one name twice, which no compiler reports."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
declared = {words[0]: words[1:] for words in map(str.split, re.findall(
    r"^jounce_declare\(([\w ]+)\)", (root / "CMakeLists.txt").read_text(), re.MULTILINE))}
api = set(re.search(r"^jounce_api\(([^)]+)\)", (root / "CMakeLists.txt").read_text(), re.MULTILINE)[1].split())
trouble = [f"CMakeLists.txt: jounce_api: there is no module {module}" for module in sorted(api - declared.keys())]


def sources(folder):
    return sorted(p for p in (root / folder).rglob("*") if p.suffix in (".hpp", ".cpp", ".in"))


def includes(path):
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if found := re.match(r'#include ["<]((?:jounce/(\w+)|(\w+)/src)/[^">]+)', line):
            yield f"{path.relative_to(root)}:{number}", found[1], found[2] or found[3], bool(found[3])


for module, uses in declared.items():
    used = set()
    for path in sources(module):
        public = "include" in path.parts and "detail" not in path.parts
        for where, name, other, private in includes(path):
            used.add(other)
            if other != module and other not in uses:
                trouble.append(f"{where}: {name}: {module} does not use {other}")
            if private and (other != module or public):
                trouble.append(f"{where}: {name} is private to {other}")
            if public and module in api and ("/detail/" in name or other not in api):
                trouble.append(f"{where}: an installed header includes {name}, which is not installed")
        trouble += [f"{path.relative_to(root)}: namespace {name} is not {module}_detail" for name in re.findall(
            r"^namespace (?:jounce::)?((?:\w+_)?detail) \{", path.read_text(), re.MULTILINE) if name != f"{module}_detail"]
    trouble += [f"CMakeLists.txt: {module} uses {m} and includes nothing of it" for m in uses if m not in used]
for path in sources("examples"):
    trouble += [f"{where}: {name} is private to {other}" for where, name, other, private in includes(path) if private]
print("\n".join(trouble) or f"{len(declared)} modules include what they declare")
sys.exit(bool(trouble))
