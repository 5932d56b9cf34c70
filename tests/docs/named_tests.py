#!/usr/bin/env python3
"""named_tests.py TESTS: each test and file that TESTS/README.md names exists, and each spec in study/optimize/ is named."""
import pathlib
import re
import sys

tests = pathlib.Path(sys.argv[1])
page = (tests / "README.md").read_text()
rows = [line for line in page.splitlines() if line.startswith("| ")]
defined = set()
for source in tests.rglob("*_test.cpp"):
    for suite, name in re.findall(r"^TEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\)", source.read_text(), re.M):
        defined.add((str(source.relative_to(tests)), f"{suite}.{name}"))

missing = []
named = 0
for row in rows:
    source = "study/optimize_verb_test.cpp"
    for file, test in re.findall(r"`([\w/]+\.(?:cpp|sh|py))`|\b([A-Z]\w+\.[A-Z]\w+)\b", row):
        source = file or source
        named += 1
        if file and not (tests / file).is_file():
            missing.append(file)
        if test and (source, test) not in defined:
            missing.append(f"{source}: {test}")
for spec in sorted((tests / "study/optimize").glob("*.toml")):
    if not re.search(rf"\b{re.escape(spec.stem)}\b", page):
        missing.append(f"{spec.name} is not on the page")
if named < 60:
    missing.append(f"only {named} names were found on the page")
sys.exit("\n".join(missing) or 0)
