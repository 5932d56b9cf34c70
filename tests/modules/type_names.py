#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Finds types, aliases and functions that two files define under one name in one namespace.

    type_names.py ROOT

All modules share the namespace jounce. A program that links two different classes of one name, or an inline function and another
one with the same parameters, has undefined behavior, and neither the compiler nor the linker reports it. The script reads the
headers of all modules, and the named namespaces of their sources."""
import collections
import pathlib
import re
import sys

from local_names import NOISE

SPACE = re.compile(r"(?:inline )?namespace ?([\w:]*)$")
TYPE = re.compile(r"(?:template ?<.*> ?(?:requires .*)?)?(?:struct|class|union|enum(?: class| struct)?) (\w+)(?: final)?(?: ?:(?!:).*)?$")
ALIAS = re.compile(r"using (\w+) ?=")
FUNCTION = re.compile(r"(?<!\w)((?:\w+::)*~?\w+|operator\W+) ?\(([^()]*(?:\([^()]*\)[^()]*)*)\)( ?const)?")
TEMPLATE = re.compile(r"template ?<")


def names_of(text):
    """The types, aliases and functions in named namespaces, outside classes and functions, as (line, qualified name)."""
    text = NOISE.sub(lambda found: "\n" * found[0].count("\n") + " ", text)
    spaces, depth, begin = [], 0, 0
    for found in re.finditer(r"[{};]", text):
        at = found.start()
        if depth == 0 and found[0] != "}":
            words = " ".join(text[begin:at].split())
            space = SPACE.match(words) if found[0] == "{" else None
            name = TYPE.match(words) if found[0] == "{" else ALIAS.match(words)
            function = FUNCTION.search(words) if found[0] == "{" and not name and "=" not in words.split("(")[0] else None
            if function and "" not in spaces and not space and not TEMPLATE.match(words):
                yield text.count("\n", 0, at) + 1, "::".join(spaces + [f"{function[1]}({function[2]}){function[3] or ''}"])
            if name and "" not in spaces:
                yield text.count("\n", 0, begin + text[begin:at].find(name[1])) + 1, "::".join(spaces + [name[1]])
            if space:
                spaces.append(space[1])
            elif found[0] == "{":
                depth += 1
        elif found[0] == "{":
            depth += 1
        elif found[0] == "}" and depth:
            depth -= 1
        elif found[0] == "}":
            spaces.pop()
        begin = at + 1


def main():
    root = pathlib.Path(sys.argv[1])
    places = collections.defaultdict(list)
    for module in re.findall(r"^jounce_declare\((\w+)", (root / "CMakeLists.txt").read_text(), re.MULTILINE):
        for path in sorted((root / module).rglob("*.[ch]pp")):
            for line, name in names_of(path.read_text()):
                places[name].append(f"{path.relative_to(root)}:{line}")
    trouble = [f"{', '.join(where)}: {name} is defined more than once" for name, where in places.items() if len(where) > 1]
    print("\n".join(trouble) or f"{len(places)} types and functions: each has one definition")
    return bool(trouble) or not places


if __name__ == "__main__":
    sys.exit(main())
