#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/stream-vectors.txt: every message of docs/stream-protocol.md as bytes, without a key
and with one. Made from that page alone with struct, zlib and hashlib: shares no code with the
library or with LCM.

    python3 wire_vectors.py            # writes the file
    python3 wire_vectors.py --check    # exit status 1 if the file is not what the script makes
"""
import hashlib
import math
import pathlib
import re
import struct
import sys
import zlib

KEY = bytes(range(32))
FILE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "stream-vectors.txt"
PAGE = FILE.with_name("stream-protocol.md")


def types():
    """The type hashes, as the page's table of messages has them."""
    rows = re.findall(r"\| `(\w+_t)` \|[^|]*\| `([0-9a-f]{16})` \|", PAGE.read_text())
    return {name: bytes.fromhex(value) for name, value in rows}


def text(value, size):
    return value.encode().ljust(size, b"\0")


def i8(*v):
    return struct.pack(f">{len(v)}b", *v)


def i32(*v):
    return struct.pack(f">{len(v)}i", *v)


def i64(*v):
    return struct.pack(f">{len(v)}q", *v)


def f64(*v):
    return struct.pack(f">{len(v)}d", *v)


NAN = math.nan
HASH = bytes(range(1, 33))
COUPLING = i8(4, 0, 1) + f64(2.5, -3.5, 0.5, 7, 100, 200, 300, 400, 500, 360)
ROWS = f64(0.1, 2, 0, 40, 0, 0, 3, 0, 0.25, 9, 40, 0, 0, 0, 3, 1)
BODIES = [
    # message, executor, session, challenge, fields in the order of the page
    ("header_t", "feeder", 11, 99, i32(3) + HASH + i8(1, 2, 2) + text("deg", 16) + text("mm", 16)
     + i32(401, 4, 400, 2)),
    ("chunk_t", "feeder", 11, 99, i32(3, 1, 400, 1, 4, 4)
     + f64(360, 0.5, -0.25, 0.125)),
    ("arm_t", "feeder", 11, 99, i32(1) + i8(2) + HASH + HASH[::-1] + COUPLING + i32(0) + i8(0, 0)),
    ("start_t", "feeder", 11, 99, i32(2) + i64(-1) + i8(2) + f64(90.5)),
    ("stop_t", "feeder", 0, 0, i32(123456789) + i8(1)),
    ("heartbeat_t", "feeder", 11, 99, i32(3) + i8(1)),
    ("ack_t", "feeder", 11, 99, i64(77) + i32(3, 1) + i64(5) + i32(8) + i8(0, 9)
     + text("no table", 160)),
    ("reply_t", "feeder", 11, 99, i64(77) + i32(2) + i8(2, 14) + i32(41)
     + text("start_position", 160)),
    ("status_t", "feeder", 11, 99, i8(3, 2) + i64(5000, 1000000) + f64(359.5, -2.5, 1e-9) + HASH[:8]
     + i32(0) + i64(17, 5, 9) + f64(-2.25, -0.25, NAN, 0.5) + i8(3) + i32(31, 77, 2048, -2147483647)
     + i64(77, 12, 11) + i32(*range(100, 116)) + i32(*range(200, 216)) + text("deg", 16)
     + text("mm", 16) + i32(5) + i8(3) + i32(55) + text("would_reverse", 160) + i8(1, 1, 6, 3, 1)
     + f64(-0.5, 0.0125)),
    ("command_t", "feeder", 11, 99, i32(7) + i8(8) + i64(4000)
     + f64(120, 200, 1000, 2000, 30000, -1, 0, 0)),
    ("path_command_t", "feeder", 11, 99, i32(8) + i8(24) + i64(-1) + f64(*range(1, 25))),
    ("queue_t", "feeder", 11, 99, i32(64) + i8(1, 0) + text("deg", 16) + text("mm", 16) + i32(512, -3)
     + i8(2) + f64(12.5) + i8(-1) + i32(100) + i8(0) + f64(-7.5, -2, math.inf)),
    ("rows_t", "feeder", 11, 99, i32(64) + i8(1) + i32(5) + i64(1000) + i32(2) + ROWS
     + bytes(8 * 1584)),
    ("queue_ack_t", "feeder", 11, 99, i64(77) + i32(64, 3, 4) + i64(1, 2) + i32(100, 200) + i64(321)
     + i8(4, 18) + i64(322) + text("row 323", 160)),
    ("master_t", "line", 0, 0, i64(9, 1700000000123456789) + i32(2) + i8(1) + f64(359.5, -7.25)
     + text("mm", 16)),
    ("event_t", "feeder", 0, 55, i64(77, 44) + i8(1) + i32(31) + i8(1) + i64(5000)
     + f64(0.000412, 88.5)),
    ("master_status_t", "feeder", 0, 0, i64(77) + text("line", 24) + text("mm", 16) + i64(5000) + i8(0)
     + f64(359.25, -7.5, 0.004) + i64(1234, 56)),
    ("claim_t", "feeder", 0, 0, i64(77, 78) + i8(1)),
    ("group_status_t", "feeder", 0, 0, i64(77, 5000) + i32(2) + text("x", 24) + text("y", 24)
     + bytes(7 * 24) + f64(10, -2.5) + f64(*[NAN] * 7) + i8(1) + i32(12, 3) + i8(1)
     + f64(12.5, 400, 80, 4.25, 380) + text("mm", 16) + text("deg", 16) + bytes(7 * 16)),
]


def message(name, executor, session, challenge, fields, key):
    front = types()[name] + bytes.fromhex("4a4e4345") + i32(2) + text(executor, 24)
    data = front + i64(session, challenge) + fields
    mac = hashlib.blake2b(data, key=key, digest_size=16).digest() if key else bytes(16)
    return data + mac + struct.pack(">I", zlib.crc32(data + mac))


def written(data):
    """Hexadecimal; 32 zeros and more as (number)."""
    pieces, zeros = [], re.compile(rb"\0{32,}")
    end = 0
    for run in zeros.finditer(data):
        pieces += [data[end:run.start()].hex(), f"({run.end() - run.start()})"]
        end = run.end()
    return "".join(pieces + [data[end:].hex()])


def made():
    lines = ["# Every message of stream-protocol.md as bytes, without a key and with the key 00 01 ... 1f;",
             "# (n): n zeros. Made by tests/oracle/wire_vectors.py."]
    for body in BODIES:
        lines += [f"{body[0]} none {written(message(*body, None))}",
                  f"{body[0]} key {written(message(*body, KEY))}"]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    if "--check" in sys.argv:
        sys.exit(FILE.read_text() != made())
    FILE.write_text(made())
