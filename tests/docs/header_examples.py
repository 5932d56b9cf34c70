#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""header_examples.py SOURCE_DIR OUTPUT MODULE...: writes the examples of the headers of the modules, also of those in `detail`, into
one source file.

An example is a block of a doc comment, indented by four spaces more than its text, in which a line ends with `;`. Each
one becomes the body of a function. Compiler errors name the header and its line. An example may use the names of
header_names.txt. `...` and `…` stand for code that is left out."""
import pathlib
import re
import sys

root, output, modules = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3:]


def examples(text):
    """(line number, namespace, source lines) of each block that is code."""
    block, first, open_namespaces = [], 0, []
    for number, line in enumerate(text.splitlines() + [""], 1):
        if opened := re.match(r"namespace ([\w:]+) \{$", line):
            open_namespaces.append(opened[1])
        if line.startswith("}  // namespace"):
            open_namespaces.pop()
        match = re.match(r"\s*///(?:     (.*)|\s*)$", line)
        if match and (match[1] or block):
            block, first = block + [match[1] or ""], first or number
            continue
        if block:
            if any(re.search(r";\s*(//.*)?$", code) for code in block):
                yield first, "::".join(open_namespaces or re.findall(r"^namespace ([\w:]+) \{$", text, re.M)[:1]), block
        block, first = [], 0


def names():
    """{scope: declarations} of header_names.txt."""
    file = root / "tests/docs/header_names.txt"
    scopes, scope = {}, ""
    for number, line in enumerate(file.read_text().splitlines(), 1):
        if line.startswith("[") and line.endswith("]"):
            scope = line[1:-1]
        elif line.startswith("using "):
            scopes[scope] = scopes.get(scope, []) + [line]
        elif line and not line.startswith("#"):
            kind, name_list = line.rsplit(": ", 1)
            scopes[scope] = scopes.get(scope, []) + [f'#line {number} "{file}"'] + [
                f"{kind}& {name} = ::jounce::header_names::any;" for name in name_list.split(", ")]
    return scopes


headers = [path for module in modules for path in sorted((root / module).glob("include/jounce/**/*.hpp"))
           if "detail" not in path.parts or any(examples(path.read_text()))]
lines = [f'#include "{str(path).split("/include/")[1]}"' for path in headers]
lines += ["#include <fstream>", "#include <iostream>", "namespace jounce::header_names {",
          "struct Any { template <class T> operator T&() const; };", "extern const Any any;",
          "void use(const auto&... values);", "}"]
known, used, count = names(), set(), 0
for path in headers:
    text = path.read_text()
    header = str(path).split("/include/jounce/")[1].removesuffix(".hpp")
    scopes = [scope for scope in ("all", path.relative_to(root).parts[0], header) if scope in known]
    for first, namespace, block in examples(text):
        count += 1
        used.update(scopes)
        code = re.sub(r"(\.\.\.|…)(?=\s*(//.*)?$)", ";", "\n".join(block), flags=re.M)
        code = re.sub(r"^\(\d+\w*\) .*$", "", code, flags=re.M)  # a formula
        lines += [f"namespace {namespace} {{", f"auto example_{count}() {{",
                  "using namespace std::chrono_literals;", "using ::jounce::header_names::use;"]
        lines += [line for scope in scopes for line in ["{", *known[scope]]]
        lines += ["{", f'#line {first} "{path}"', re.sub(r"\.\.\.|…", "", code), "}", "}" * len(scopes), "}", "}"]
if count == 0:
    sys.exit("header_examples.py: no header has an example")
if lost := sorted(known.keys() - used):
    sys.exit(f"header_names.txt: no header with an example has the name {', '.join(lost)}: remove its section")
output.write_text("\n".join(lines) + "\n")
