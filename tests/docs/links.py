#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""links.py SOURCE_DIR: checks the links of all Markdown pages.

Reports file:line of each relative link whose file or anchor does not exist, of each page under docs/ that no chain of
links from README.md reaches, of each page with another number of first-level headings than one, and of each source file in
backticks that does not exist, and of each example and script that its folder's README.md does not name."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1]).resolve()
errors = []


def without_code(text):
    """Fenced blocks become empty lines, so that line numbers stay."""
    return re.sub(r"^( *)(```|~~~).*?^\1\2\s*$", lambda m: "\n" * m[0].count("\n"), text, flags=re.S | re.M)


def anchors_of(text):
    found, count = set(), {}
    for heading in re.findall(r"^#+ +(.*?) *#*$", without_code(text), re.M):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
        name = re.sub(r"[^\w\- ]", "", plain).strip().replace(" ", "-")
        n = count.get(name, 0)
        count[name] = n + 1
        found.add(f"{name}-{n}" if n else name)
    return found | set(re.findall(r'<a (?:id|name)="([^"]+)"', text))


# Without git, which a fresh machine need not have: all files but those that a build or a script makes.
MADE = {".git", "build", "demo-out", "__pycache__"}
paths = (p.relative_to(root) for p in root.rglob("*") if p.is_file())
files = {str(p) for p in paths if not MADE & set(p.parts)}
folders = {str(parent) for name in files for parent in pathlib.PurePath(name).parents}
pages = {name: (root / name).read_text() for name in sorted(files) if name.endswith(".md")}
anchors = {name: anchors_of(text) for name, text in pages.items()}
linked = {name: set() for name in pages}
modules = {pathlib.PurePath(name).parts[0] for name in files}
SOURCE = re.compile(r"`([\w.\-/]+\.(?:hpp|cpp|py|sh|toml|md))(?::\d+)?`")

for name, text in pages.items():
    prose = without_code(text)
    if name.startswith("docs/") or name == "README.md":
        heads = len(re.findall(r"^# ", prose, re.M))
        if heads != 1:
            errors.append(f"{name}:1: {heads} first-level headings, must be 1")
    for m in re.finditer(r"(?<!\\)\]\(<?([^)\s>]+)>?(?: \"[^\"]*\")?\)", re.sub(r"`[^`\n]*`", lambda c: " " * len(c[0]), prose)):
        target, line = m[1], prose.count("\n", 0, m.start()) + 1
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        to = name if not path else str((root / name).parent.joinpath(path).resolve().relative_to(root))
        if to in folders and f"{to}/README.md" in files:
            to = f"{to}/README.md"
        if to not in files and to not in folders:
            errors.append(f"{name}:{line}: {target} does not exist")
        elif anchor and to in anchors and anchor not in anchors[to]:
            errors.append(f"{name}:{line}: {to} has no heading #{anchor}")
        if to in pages:
            linked[name].add(to)
    if name.startswith("docs/decisions/") or name == "CHANGELOG.md":
        continue  # they name files as they were
    for m in SOURCE.finditer(prose):
        path = m[1]
        first = path.split("/")[0]
        here = str((root / name).parent.joinpath(path).resolve().relative_to(root)) if ".." not in path else ""
        placeholder = re.search(r"[A-Z]{3,}", path) and not path.endswith("README.md")
        known = path in files or here in files
        if path.endswith((".hpp", ".cpp")):  # an #include names the end of a path
            known = known or any(f.endswith("/" + path) for f in files)
        if "/" in path and (first in modules or path.endswith((".hpp", ".cpp"))) and not placeholder and not known:
            errors.append(f"{name}:{prose.count(chr(10), 0, m.start()) + 1}: `{path}` does not exist")

for index in ("examples/README.md", "scripts/README.md"):  # they name all that is beside them
    if index in pages:
        folder = index.partition("/")[0]
        for entry in sorted({pathlib.PurePath(f).parts[1] for f in files if f.startswith(folder + "/")} - {"README.md"}):
            if f"({entry})" not in pages[index]:
                errors.append(f"{index}:1: {entry} is not in the index")

reached, todo = set(), ["README.md"]
while todo:
    page = todo.pop()
    if page not in reached:
        reached.add(page)
        todo += linked[page]
errors += [f"{name}:1: no chain of links from README.md reaches this page"
           for name in pages if name.startswith("docs/") and name not in reached]
print("\n".join(errors) or f"{len(pages)} pages: all links resolve, all pages of docs/ can be reached")
sys.exit(1 if errors else 0)
