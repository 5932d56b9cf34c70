#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""one_definition.py ROOT: no two files of the rooms define a type of one name in one namespace. All rooms share
jounce::detail; two types of one name there are one to the linker, which keeps the functions of either, and no
compiler sees both. Exit status 1 and the places where it happens."""
import pathlib
import re
import sys

ROOMS = "profiles cam pvt gear optimize validate io study command stream plot axis drive executor web cli".split()
NAMESPACE = re.compile(r"(?:inline )?namespace\s*([\w:]*)\s*\{")
TYPE = re.compile(r"(?:template <.*>\s*)?(?:struct|class|enum class|enum)\s+(\w+)(?:\s+final)?\s*(?:$|\{|:(?!:))")


def types(path):
    """The types that a file defines at the level of a namespace that others can see."""
    inside = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        line, _, comment = line.partition("//")
        if opened := NAMESPACE.match(line):
            inside.append(opened[1])
        elif line.startswith("}") and comment.startswith(" namespace"):
            inside.pop()
        elif (defined := TYPE.match(line.rstrip())) and "" not in inside:
            yield "::".join([*inside, defined[1]]), f"{path}:{number}"


def main():
    root = pathlib.Path(sys.argv[1])
    places = {}
    for room in ROOMS:
        for path in sorted((root / room).rglob("*.[hc]pp")):
            for name, place in types(path):
                places.setdefault(name, []).append(place)
    twice = {name: where for name, where in places.items() if len(where) > 1}
    for name, where in sorted(twice.items()):
        print(f"{name} is defined in " + " and in ".join(where))
    print(f"{len(places)} types, {len(twice)} of them of a name that another has")
    if len(places) < 500:
        sys.exit("so few types: the files were not understood")
    sys.exit(1 if twice else 0)


if __name__ == "__main__":
    main()
