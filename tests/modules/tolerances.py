#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Finds tolerances without a name: literals of 9e-5 and less in the sources and headers of the modules.

    tolerances.py ROOT

A tolerance has a name if it initializes a constant, a member, a default argument or a variable of its own. Conversions of units
(ns to s) do not count. Use a share of jounce/profiles/detail/tolerances.hpp, or define a constant whose name states what the
tolerance is for. The number of a comparison is then explained once."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
NUMBER = r"(?<![\w.])\d+(?:\.\d+)?e-(?:[5-9]|\d\d+)\b"
ALLOWED = [
    r'//[^\n]*|"(?:\\.|[^"\\\n])*"',  # comments and texts
    r"constexpr [\w:<> ]*\w(?:\{| =)[^;]*;",
    rf"\w =\s+{NUMBER}(?=\s*[;,)}}])",
    r"static_cast<double>\((?:[^()]|\([^()]*\))*\) \* 1e-[69]\b",  # ns to s or ms
    r"\bdefine\( *, [^)]*\)",  # base/src/units.cpp
]


def unnamed(text):
    """The literals, as (line, literal)."""
    for pattern in ALLOWED:
        text = re.sub(pattern, lambda found: re.sub(r"[^\n]", " ", found[0]), text)
    for found in re.finditer(NUMBER, text):
        yield text.count("\n", 0, found.start()) + 1, found[0]


modules = re.findall(r"^jounce_declare\((\w+)", (root / "CMakeLists.txt").read_text(), re.MULTILINE)
files = sorted(p for m in modules for folder in ("src", "include") for p in (root / m / folder).rglob("*.[hc]pp"))
trouble = [f"{path.relative_to(root)}:{line}: {literal} has no name"
           for path in files for line, literal in unnamed(path.read_text())]
print("\n".join(trouble) or f"{len(files)} files: every tolerance has a name")
sys.exit(bool(trouble) or not files)
