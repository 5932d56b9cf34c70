#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Hash and length of every type in stream/lcm, from LCM's type specification alone: shares no code
with lcm-gen. Prints rows for docs/stream-protocol.md and tests/stream/message/wire_test.cpp."""
import pathlib
import re

SIZES = {"int8_t": 1, "boolean": 1, "byte": 1, "int16_t": 2, "int32_t": 4, "float": 4,
         "int64_t": 8, "double": 8}
FOLDER = pathlib.Path(__file__).resolve().parents[2] / "stream" / "lcm"


def signed(value):
    value &= (1 << 64) - 1
    return value - (1 << 64) if value >> 63 else value


def add_byte(value, byte):
    return signed(((value << 8) ^ (value >> 55)) + byte)


def add_text(value, text):
    value = add_byte(value, len(text))
    for letter in text.encode():
        value = add_byte(value, letter)
    return value


def read(name):
    text = re.sub(r"//.*", "", (FOLDER / f"{name}.lcm").read_text())
    inside = re.search(r"struct\s+\w+\s*\{(.*)\}", text, re.S).group(1)
    fields = []
    for line in inside.split(";"):
        match = re.match(r"\s*(\w+)\s+(\w+)(?:\[(\d+)\])?\s*$", line)
        if match:
            fields.append((match.group(1), match.group(2), match.group(3)))
    return fields


def hash_of(name):
    value = signed(0x12345678)
    for kind, member, size in read(name):
        value = add_text(value, member)
        if kind in SIZES:
            value = add_text(value, kind)
        value = add_byte(value, 1 if size else 0)
        if size:
            value = add_text(add_byte(value, 0), size)  # 0: a constant size
    value = signed(value + sum(hash_of(kind) for kind, _, _ in read(name) if kind not in SIZES))
    return signed((value << 1) + ((value >> 63) & 1))


def bytes_of(name):
    return sum((SIZES[kind] if kind in SIZES else bytes_of(kind)) * int(size or 1)
               for kind, _, size in read(name))


if __name__ == "__main__":
    for path in sorted(FOLDER.glob("*.lcm")):
        if path.stem in ("envelope_t", "coupling_t"):
            continue
        print(f"  expect_type<jounce_lcm::{path.stem}>"
              f"(0x{hash_of(path.stem) & (1 << 64) - 1:016x}, {8 + bytes_of(path.stem)});")
