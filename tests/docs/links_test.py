#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""links_test.py LINKS: links.py reports each kind of error in a small tree, and nothing in the mended tree."""
import pathlib
import subprocess
import sys
import tempfile

WRONG = "# Title\n\n[a](none.md) [b](docs/a.md#gone)\n`old/x.hpp`\n# Second\n"
RIGHT = "# Title\n\n[a](docs/a.md#its-part) [b](docs/b.md)\n`new/x.hpp`\n\n```sh\n# no heading, [no link](none.md)\n```\n"
EXPECTED = ["README.md:3: none.md does not exist", "README.md:3: docs/a.md has no heading #gone", "README.md:4: `old/x.hpp` does not exist",
            "README.md:1: 2 first-level headings, must be 1", "docs/b.md:1: no chain of links from README.md reaches this page",
            "scripts/README.md:1: run is not in the index"]

with tempfile.TemporaryDirectory() as name:
    root = pathlib.Path(name)
    for folder in ("docs", "src/new"):
        (root / folder).mkdir(parents=True)
    (root / "docs/a.md").write_text("# A\n\n## Its part\n")
    (root / "docs/b.md").write_text("# B\n")
    (root / "src/new/x.hpp").write_text("")
    (root / "scripts").mkdir()
    (root / "scripts/run").write_text("")
    for text, index, status, expected in ((WRONG, "", 1, EXPECTED), (RIGHT, "[run](run)", 0, [])):
        (root / "README.md").write_text(text)
        (root / "scripts/README.md").write_text(f"# Scripts\n\n{index}\n")
        run = subprocess.run([sys.executable, sys.argv[1], name], capture_output=True, text=True)
        found = run.stdout.split("\n")[:-1] if status else []
        if run.returncode != status or sorted(found) != sorted(expected):
            sys.exit(f"exit status {run.returncode}, not {status}:\n{run.stdout}{run.stderr}")
