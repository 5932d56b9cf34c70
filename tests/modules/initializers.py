#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""initializers.py SOURCE_DIR: lists members of public structs that warn in a designated initializer that omits them.

g++ -Wextra warns about an omitted member without an initializer. Such a member must be given: a number, an enumerator, a
pointer, a reference or a span, before all members with an initializer, or a type without a default constructor."""
import pathlib
import re
import sys

# Types without a default constructor, and types that are not copied.
MUST_BE_GIVEN = (r"(Cam|Trajectory|Curve<Over>|LazyCurve|Table|TableFile|Sampled|Plan|Path|Program|SpecNumbers|Sender|"
                 r"QueueMovement)$|std::variant<(Cam|External),|(Ring|Seqlock|std::atomic)<")
FUNCTION = r"\)\s*(const)?\s*(noexcept)?\s*(override)?\s*(:[^;]*)?$|\boperator\b.*\)"
NO_MEMBER = r"(static|using|friend|enum|struct|class|template|typedef|explicit|virtual|\[\[nodiscard|public|private)"
SCALAR = (r"(const )?(double|float|bool|char|int|unsigned|long|std::u?int\d+_t|std::size_t|Nanos)\b|.*[&*]$|"
          r"(const )?std::span<")


def structs(text):
    """(line, name, body) of each struct, also of structs in structs and classes."""
    for found in re.finditer(r"^( *)(?:template <[^\n]*>\n *)?struct (?:\[\[\w+\]\] )?(\w+) (?:: [^{]*)?\{\n(.*?)^\1\};", text,
                             re.M | re.S):
        yield text[: found.start()].count("\n") + 1, found[2], found[3]
        for line, name, body in structs(found[3]):
            yield text[: found.start(3)].count("\n") + line, name, body


def members(body):
    """(line, type, name, initialized) of each data member."""
    code = re.sub(r"//[^\n]*", "", body)
    line, depth, statement, begin = 0, 0, "", 0
    for character in code:
        if character == "\n":
            line += 1
        if character in "{}":
            depth += 1 if character == "{" else -1
            if depth == 0 and character == "}" and re.search(FUNCTION, statement.split("{")[0], re.S):
                statement = ""
                continue
        if character == ";" and depth == 0:
            text = " ".join(statement.split())
            statement = ""
            if not text or re.match(NO_MEMBER, text):
                continue
            declared = re.split(r"[={]", text, maxsplit=1)
            head = declared[0].strip()
            if "(" in re.sub(r"<[^<>]*(<[^<>]*>)?[^<>]*>", "", head):
                continue
            found = re.match(r"(.*?[\s>&*])(\w+(?:\s*,\s*\w+)*)$", head)
            if found:
                yield begin, found[1].strip(), found[2], len(declared) > 1
            continue
        if not statement.strip():
            begin = line
        statement += character


def scalar(kind, enums):
    return kind.split("::")[-1] in enums or re.match(SCALAR, kind) is not None


def main(root):
    errors = []
    headers = {path: path.read_text() for path in sorted(root.glob("*/include/jounce/**/*.hpp"))
               if "detail" not in path.parts}
    enums = {name for text in headers.values() for name in re.findall(r"enum (?:class )?(\w+)", text)}
    for path, text in headers.items():
        for first, name, body in structs(text):
            if re.search(rf"^\s*(explicit |constexpr )*{name}\(", body, re.M):
                continue  # a constructor: no aggregate
            seen = False
            for line, kind, member, initialized in members(body):
                seen = seen or initialized
                if initialized or re.match(MUST_BE_GIVEN, kind) or (scalar(kind, enums) and not seen):
                    continue
                errors.append(f"{path.relative_to(root)}:{first + line + 1}: {name}::{member} ({kind}): add an initializer, "
                              "= {}")
    return errors


if __name__ == "__main__":
    found = main(pathlib.Path(sys.argv[1]))
    print("\n".join(found))
    sys.exit(1 if found else 0)
