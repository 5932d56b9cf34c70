#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""page_snippets.py SOURCE_DIR OUTPUT: writes all C++ blocks of README.md and docs/ into one source file.

Each block becomes the body of a function. Compiler errors name the page and its line. A block may use the names of
page_names.hpp. All public headers are included. `…` in a block stands for code that is left out."""
import pathlib
import re
import sys

root, output = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
headers = sorted({str(path).split("/include/")[1] for path in root.glob("*/include/jounce/**/*.hpp")
                  if "detail" not in path.parts})
lines = [f'#include "{header}"' for header in headers]
lines.append('#include "page_names.hpp"')

blocks = 0
for page in [root / "README.md", *sorted((root / "docs").rglob("*.md"))]:
    text = page.read_text()
    for block in re.finditer(r"^```cpp\n(.*?)^```", text, re.S | re.M):
        blocks += 1
        first = text.count("\n", 0, block.start()) + 2
        code = re.sub(r"^#include.*$", "", block[1], flags=re.M).replace("…", ";")
        lines += [f"namespace jounce::pages::block_{blocks} {{", "void shown() {", f'#line {first} "{page}"', code, "}", "}"]
        for header in re.findall(r'^#include [<"](jounce/[^>"]+)[>"]', block[1], re.M):
            if header not in headers:
                sys.exit(f"{page}:{first}: no public header {header}")
if blocks == 0:
    sys.exit("page_snippets.py: no page has a C++ block")
output.write_text("\n".join(lines) + "\n")
