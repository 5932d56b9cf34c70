#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every rejected value is reported at its key: wrong_values.py JOUNCE [SPEC...]

Takes the example of `jounce new KIND` for each kind of spec, and each SPEC, and puts a wrong value at each of the keys, one
at a time: negative, zero, huge, a text, a unit of another quantity, a number in place of a text. If `jounce check` rejects the
file, then

  - the message is at the line of the key that it names, not at the header of its table;
  - this is the line of the changed key, or the message repeats the wrong value: a value can contradict another key.
    A huge value can also make a computed number impossible, or no table can resolve the whole motion;
  - a value at the changed key is repeated;
  - a key that the file gives is not missing;
  - if this key has a unit, a unit or a noun follows each number of the message, except 0. `jounce check` itself names the
    unit of a key when the value has the unit of another quantity.

A value that the check accepts is no error of this test.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

JOUNCE = sys.argv[1]
KEY = re.compile(r'([A-Za-z_]\w*)\s*=\s*("(?:[^"\\]|\\.)*"|[-+]?\d[\w.+-]*|true|false)')
UNIT = re.compile(r"give the value in (\S.*?)(?: \[|$)", re.M)
BARE = re.compile(r"(?<![\w.\[/\"^-])(?<!\^-)(-?\d[\d.]*(?:e[-+]?\d+)?)"
                  r"(?=$|[,:;)]| (?:and(?! -?\d)|are|at|from|with|for|there|along|or|\[))", re.M)
QUANTITY = re.compile(r'"[-+]?\d[\d.e+-]*\s*[^"]*"$')
MESSAGE = re.compile(r"^(?:jounce: )?(\S+\.toml):(\d+):(\d+): (?:error: )?([^:=]+?)(?: = |: )(.*)$", re.M)


def without_comment(line):
    quoted = False
    for at, letter in enumerate(line):
        quoted ^= letter == '"'
        if letter == "#" and not quoted:
            return line[:at]
    return line


def values(text):
    """(index of the line, begin, end, text) of each value."""
    for number, line in enumerate(text.split("\n")):
        for match in KEY.finditer(without_comment(line)):
            if line[:match.start()].count('"') % 2 == 0:
                yield number, match.start(2), match.end(2), match.group(2)


def wrong_ones(value):
    """The first wrong value of a number has the unit of another quantity."""
    if value in ("true", "false"):
        return ['"yes"', "3"]
    if value[0] != '"' or QUANTITY.match(value):
        return ['"5 kg"', "-1", "0", '"many"', "1e9"]
    return ['"nonsense_word"', "3"]


def bare_number(message):
    """The first number of a message without a unit or a noun; "" if there is none. An error number is a number of its own."""
    text = re.sub(r"\(PMC600 error \d+\)|(?:segment|zone|point|knot|axis) \d+|count = \d+", "", message)
    return next((number for number in BARE.findall(text) if float(number) != 0), "")


def repeats(message, wrong):
    if wrong == "1e9":  # a message may write all digits
        return re.search(r"(?<![\w.])(1e\+?0?9|1000000000)(?![\w.])", message) is not None
    return re.search(r"(?<![\w.])" + re.escape(wrong.strip('"')) + r"(?![\w.])", message) is not None


def fault_of(output, status, file, lines, changed, wrong, unit):
    """The rule that the answer breaks; "" if it breaks none. `unit`: of the changed key."""
    if status in (0, 1):
        return ""
    if status != 2:
        return f"exit status {status}"
    messages = [m for m in MESSAGE.finditer(output) if m.group(1) == file]
    if not messages:
        return "" if "no table resolves both" in output else "no place"
    for message in messages:
        line, key, rest = int(message.group(2)), message.group(4), message.group(5)
        name = re.sub(r"\[\d+\]$", "", key.split(".")[-1]).strip("[]")
        if re.search(rf"\b{name}\b", without_comment(lines[line - 1])) is None and "is missing" not in rest:
            return f"the line {line} does not contain {name}"
        if "is missing" in rest and re.search(rf"^\s*{re.escape(name)}\s*=", lines[line - 1]):
            return f"{key} is given"
        bare = bare_number(rest) if unit and line == changed and wrong != '"5 kg"' else ""
        if bare:
            return f"{bare} has no unit; the value has {unit}"
    if any(int(m.group(2)) == changed for m in messages):
        return "" if repeats(output, wrong) else "the value is not repeated"
    return "" if wrong == "1e9" or repeats(output, wrong) else "another line, without the wrong value"


def example(kind):
    return subprocess.run([JOUNCE, "new", kind], capture_output=True, text=True, check=True).stdout


def kinds():
    """The kinds that the program names; a key is no spec."""
    answer = subprocess.run([JOUNCE, "new", "?"], capture_output=True, text=True).stderr
    words = re.search(r"must be one of ([\w, ]+)", answer).group(1).split(", ")
    return [word for word in words if word != "key"]


def templates(folder):
    """The example of each kind, in a folder of its own."""
    for kind in kinds():
        here = folder / kind
        here.mkdir()
        axis = example("axis")
        if kind == "machine":  # the specs that its example names
            (here / "feeder.toml").write_text(axis)
            (here / "knife.toml").write_text(axis.replace('name = "feeder"', 'name = "knife"'))
        (here / "spec.toml").write_text(example(kind))
        yield here / "spec.toml"


def copies(folder, specs):
    """The specs, with the files beside them."""
    for number, spec in enumerate(map(pathlib.Path, specs)):
        here = folder / str(number)
        shutil.copytree(spec.parent, here)
        yield here / spec.name


def main():
    tried = faults = 0
    with tempfile.TemporaryDirectory() as folder:
        for spec in [*templates(pathlib.Path(folder)), *copies(pathlib.Path(folder), sys.argv[2:])]:
            text = spec.read_text()
            for number, begin, end, value in values(text):
                unit = ""
                for wrong in wrong_ones(value):
                    lines = text.split("\n")
                    lines[number] = lines[number][:begin] + wrong + lines[number][end:]
                    spec.write_text("\n".join(lines))
                    run = subprocess.run([JOUNCE, "check", spec.name], cwd=spec.parent, capture_output=True, text=True)
                    output = run.stderr + run.stdout
                    tried += 1
                    fault = fault_of(output, run.returncode, spec.name, lines, number + 1, wrong, unit)
                    if wrong == '"5 kg"':
                        named = UNIT.search(output)
                        unit = named.group(1) if named else ""
                    if fault:
                        faults += 1
                        print(f"{spec}:{number + 1}: {lines[number].strip()}\n  {fault}\n  {output.strip()}")
            spec.write_text(text)
    print(f"{tried} wrong values, {faults} faults")
    assert tried > 500, "the examples must have keys"
    return faults > 0


if __name__ == "__main__":
    sys.exit(main())
