#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Finds installed headers that no user needs.

    installed_headers.py ROOT

A page of docs/ (but no decision) or an example names each header of the modules in jounce_api(), by its path jounce/MODULE/x.hpp, or
an installed header includes it. A header that only other modules of Jounce include belongs into `jounce/MODULE/detail`, and one that
only its own module includes into MODULE/src."""
import pathlib
import re
import sys

# Only other modules include these headers of path/. They are to move to its `detail`.
WAITING = {f"jounce/path/{name}.hpp" for name in (
    "axes_by_stretch", "command_times", "direct", "jog", "plan_progress", "reach", "rotary")}

root = pathlib.Path(sys.argv[1])
api = re.search(r"^jounce_api\(([^)]+)\)", (root / "CMakeLists.txt").read_text(), re.MULTILINE)[1].split()
headers = {}  # jounce/MODULE/x.hpp -> its file
for module in api:
    for path in (root / module / "include").rglob("*.hpp"):
        if "detail" not in path.parts:
            headers[path.relative_to(root / module / "include").as_posix()] = path
pages = [root / "README.md", *(p for p in (root / "docs").rglob("*.md") if "decisions" not in p.parts), *(root / "examples").rglob("*.cpp")]
needed = set()
waiting = [name for page in pages for name in re.findall(r"jounce/[\w/]+\.hpp", page.read_text())]
while waiting:
    name = waiting.pop()
    if name in headers and name not in needed:
        needed.add(name)
        waiting += re.findall(r'#include "(jounce/[^"]+)"', headers[name].read_text())
trouble = [f"{name}: remove it from WAITING" for name in sorted(WAITING - headers.keys() | WAITING & needed)]
trouble += [f"{headers[name].relative_to(root)}: neither a page nor an example names it, and no installed header includes it"
           for name in sorted(headers.keys() - needed - WAITING)]
print("\n".join(trouble) or f"{len(headers)} installed headers: users need each of them")
sys.exit(bool(trouble) or not headers)
