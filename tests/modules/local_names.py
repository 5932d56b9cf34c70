#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Finds local names that two sources of a module share.

    local_names.py ROOT

The release build compiles many sources of a module as one, so their unnamed namespaces are one scope. An equal name is an error
only if both files are in one batch, and a call can select the function of the other file. Identical code becomes one function in a
private header. Different code gets different names. Aliases of one type may be equal.

A name is local if a source declares it in an unnamed namespace, or as static, or as a constant, a type, an alias or a macro outside
a class. A type is not local if a header of the module declares it. Two functions may share a name if they are overloads: their
numbers of parameters differ, or the types of a parameter do, where all types of numbers are equal, and all types of texts. A source
that is compiled alone (APART) shares no scope. The script also reports a declaration in which it finds no name."""
import collections
import pathlib
import re
import sys

NOISE = re.compile(r"""//[^\n]*|/\*.*?\*/|\[\[.*?\]\]|R"(?P<end>[^(\s]*)\(.*?\)(?P=end)"|"(?:\\.|[^"\\\n])*"|(?<!\w)'(?:\\.|[^'\\\n])+'"""
                   r"|^#(?:\\\n|[^\n])*", re.DOTALL | re.MULTILINE)
TYPE = re.compile(r"(?:struct|class|union|enum(?: class)?) (\w+)(?: final)?(?: :[^{]*)? ?(?:\{\}|;)")
ALIAS = re.compile(r"(?:using|namespace|concept) (\w+) =")
DECLARED = re.compile(r"(?P<qualified>::)?(?P<name>\b(?!operator\b)\w+)~? ?(?P<after>\(\)|\{\}|\[\]|=(?!=)|;)")
UNCLEAR = re.compile(r"enum (?!class )|[^(]*,[^()]*$|.*\(\) ?\(\)")  # enumerators, several variables, a pointer to a function
NO_NAME = re.compile(r"static_assert|using (?:namespace )?[\w:]+;|template \w+ [\w:]+;|(?:struct|class) [\w:]+~|.*\boperator\b|;")


def statements(text):
    """The declarations outside classes and functions, as (line, in an unnamed namespace, text, text without contents of brackets,
    contents of the first round brackets)."""
    text = NOISE.sub(lambda found: "\n" * found[0].count("\n") + (" " if found[0][0] in "/[#" else '""'), text)
    spaces, outline, depth, begin, opened, first = [], "", 0, 0, 0, None
    for at, sign in enumerate(text):
        if not outline.strip():
            outline, begin, first = "", at, None
        if sign in "({[":
            if sign == "{" and depth == 0 and (space := re.match(r"\s*(?:inline )?(?:namespace ?([\w:]*)|extern \"\")\s*$", outline)):
                spaces.append(space[1] == "")
                outline = ""
                continue
            outline += sign if depth == 0 else ""
            opened = at if depth == 0 else opened
            depth += 1
        elif sign == "}" and depth == 0:
            spaces.pop()
        elif sign in ")}]":
            depth -= 1
            outline += sign if depth == 0 else ""
            if depth == 0 and sign == ")" and not re.search(r"\b(?:decltype|alignas|noexcept|explicit|requires) ?\(\)$", outline):
                first = text[opened + 1:at] if first is None else first
        elif depth == 0:
            outline += sign
        body = sign == "}" and not re.search(r"(?<!operator)=", outline) and not re.match(r"\s*[;,{]", text[at + 1:at + 200])
        if depth == 0 and outline.strip() and (sign == ";" or body):
            yield text.count("\n", 0, begin) + 1, any(spaces), text[begin:at], outline, first or ""
            outline = ""


def without_angles(outline):
    outline = re.sub(r"\boperator ?[-+*/%^&|!=<>]+", "operator", " ".join(outline.replace("->", "=>").split()))
    before = None
    while before != outline:
        before, outline = outline, re.sub(r"(?<=\w) ?<[^<>]*>(?!=)", "~", outline)
    return re.sub(r"^template ?~(?: requires [\w:]+~?(?:\(\))?)? ", "", outline)


def signature(parameters):
    """The types of parameters, as a tuple of words."""
    before = None
    while before != parameters:
        before, parameters = parameters, re.sub(r"<([^<>,]*),", r"<\1;", parameters)
    types = []
    for parameter in filter(str.strip, parameters.split(",")):
        words = re.findall(r"[\w:]+|[<>&*;]", parameter.split("=")[0].replace("const ", ""))
        words = words[:-1] if len(words) > 1 and re.match(r"\w", words[-1]) and words[-2] != "<" else words
        of = " ".join(words)
        of = re.sub(r"^(?:bool|int|unsigned|float|double|std::size_t|std::ptrdiff_t|std::u?int\d+_t)$", "number", of)
        types.append(re.sub(r"^(?:std::string(?:_view)?(?: &)?|char \*)$", "text", of))
    return tuple(types)


def local_names(path):
    """The local names of a source, as {name: (line, what)}, and the declarations in which none was found. `what` is a set of
    signatures for a function, the text of the type for an alias, and otherwise None."""
    text = path.read_text()
    names, unread = {}, []
    for found in re.finditer(r"^#define (\w+)", text, re.MULTILINE):
        if f"#undef {found[1]}" not in text:
            names[found[1]] = text.count("\n", 0, found.start()) + 1, None
    for line, unnamed, whole, outline, parameters in statements(text):
        outline = without_angles(outline)
        if unnamed and UNCLEAR.match(outline):
            unread.append(f"{line}: declare each name by itself, and enumerators in an `enum class`: {outline[:90]}")
        name = TYPE.match(outline) or ALIAS.match(outline)
        if not name and not NO_NAME.match(outline):
            name = DECLARED.search(re.sub(r"\b(?:decltype|alignas|noexcept|explicit|requires) ?\(\)", "", outline))
            constant = re.match(r"(?:static )?(?:constexpr|const) [^*=]*$", outline[:name.end("name")]) if name else None
            if name and not unnamed and not outline.startswith("static ") and not (constant and name["after"] != "()"):
                continue
            if not name and unnamed:
                unread.append(f"{line}: no name found in: {outline[:90]}")
            if name and name["qualified"]:
                continue
        if name:
            what = None
            if name.re is ALIAS:
                what = whole.partition("=")[2].strip()
            elif name.re is DECLARED and name["after"] == "()":
                what = {signature(parameters)}
            known = names.setdefault(name["name"] if name.re is DECLARED else name[1], (line, what))[1]
            if isinstance(known, set) and isinstance(what, set):
                known |= what
    return names, unread


def shared(one, other):
    """True if two declarations of one name, as in local_names(), are neither overloads nor equal aliases."""
    if isinstance(one, set) and isinstance(other, set):
        return bool(one & other)
    return not isinstance(one, str) or one != other


def main():
    root = pathlib.Path(sys.argv[1])
    trouble, count = [], 0
    for module in re.findall(r"^jounce_declare\((\w+)", (root / "CMakeLists.txt").read_text(), re.MULTILINE):
        headers = "\n".join(path.read_text() for path in (root / module).rglob("*.hpp"))
        public = set(re.findall(r"\b(?:struct|class|union|enum) (?:class )?(\w+)", headers))
        alone = re.findall(r"[\w/]+\.cpp", " ".join(re.findall(r"\bAPART\b([^)A-Z]*)", (root / module / "CMakeLists.txt").read_text())))
        places = collections.defaultdict(list)
        for path in sorted((root / module).rglob("*.cpp")):
            if str(path.relative_to(root / module)) in alone:
                continue
            names, unread = local_names(path)
            trouble += [f"{path.relative_to(root)}:{problem}" for problem in unread]
            for name, (line, what) in names.items():
                if name in public:
                    continue
                where = f"{path.relative_to(root)}:{line}"
                others = [other for other, known in places[name] if shared(what, known)]
                if others:
                    trouble.append(f"{where}: {name} is also in {', '.join(others)}")
                places[name].append((where, what))
        count += len(places)
    print("\n".join(trouble) or f"{count} local names: each is in one source of its module, or an overload")
    return bool(trouble) or not count


if __name__ == "__main__":
    sys.exit(main())
