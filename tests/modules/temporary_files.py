#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Finds tests that share a temporary file.

    temporary_files.py ROOT

ctest runs each test as a process of its own, several at once, so a fixed name in the folder of temporary files belongs to several
tests. A C++ test names its files by test::TemporaryFolder, by mkdtemp, or by its process number."""
import pathlib
import re
import sys

STATEMENT = re.compile(r"[^;{}]*(?:temp_directory_path|TempDir|\"/tmp/)[^;]*;")
OWN = re.compile(r"getpid|XXXXXX")

root = pathlib.Path(sys.argv[1])
found = []
for path in sorted((root / "tests").rglob("*.[ch]pp")):
    text = path.read_text()
    found += [f"{path.relative_to(root)}:{text.count(chr(10), 0, match.end()) + 1}: this temporary file has one name for all "
              "processes: use test::TemporaryFolder" for match in STATEMENT.finditer(text) if not OWN.search(match[0])]
print("\n".join(found))
sys.exit(bool(found))
