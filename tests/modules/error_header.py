#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""error_header.py SOURCE_DIR: lists public headers that mention InputError, but do not include error.hpp, directly or through
another public header. A program that includes such a header could not catch the exception."""
import pathlib
import re
import sys

ERROR = "jounce/profiles/error.hpp"


def main(root):
    headers = {"jounce/" + str(path).split("/include/jounce/")[1]: path for path in root.glob("*/include/jounce/**/*.hpp")}
    text = {name: path.read_text() for name, path in headers.items()}
    included = {name: set(re.findall(r'#include "(jounce/[^"]+)"', text[name])) for name in text}

    def reaches(name, seen):
        seen.add(name)
        return name == ERROR or any(reaches(used, seen) for used in included.get(name, set()) - seen)

    return [f"{headers[name].relative_to(root)}: include {ERROR}, the header of InputError" for name in sorted(text)
            if "InputError" in text[name] and not reaches(name, set())]


if __name__ == "__main__":
    found = main(pathlib.Path(sys.argv[1]))
    print("\n".join(found))
    sys.exit(1 if found else 0)
