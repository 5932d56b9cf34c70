#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Reads tables in LCM logs and MCAP files without code of Jounce, and compares them with the motion.

usage: table_containers.py JOUNCE REPOSITORY

- An LCM log is read by LCM's own library (liblcm) and by the decoder that lcm-gen writes for the type in io/lcm.
- An MCAP file is read here, record by record, as https://mcap.dev/spec describes the format.

The knots must be those of the CSV, to the last bit. A quintic through them is compared with the closed form of the
motion at 100 000 places.
"""

import ctypes
import ctypes.util
import json
import pathlib
import struct
import subprocess
import sys
import tempfile

SPEC = """jounce = 1
kind = "cam"
name = "E"
units = { master = "deg", position = "mm" }
periodic = true
start = { master = 0, slave = 0 }
[[segment]]
law = "345"
end = { master = 120, slave = 40 }
[[segment]]
law = "dwell"
end = { master = 180, slave = 40 }
[[segment]]
law = "345"
end = { master = 300, slave = 0 }
[[segment]]
law = "dwell"
end = { master = 360, slave = 0 }
"""
PLACES = 100_000


def law_345(s):
    s = min(max(s, 0.0), 1.0)
    return s**3 * (10 + s * (-15 + 6 * s))


def motion_e(master):
    return 40 * (law_345(master / 120) - law_345((master - 180) / 120))


def quintic(a, b, x):
    """The value at x of the polynomial of degree 5 through two knots (x, p, v, a), in powers of x - a.x."""
    h, u = b[0] - a[0], x - a[0]
    p = b[1] - a[1] - a[2] * h - a[3] * h * h / 2
    v = (b[2] - a[2] - a[3] * h) * h
    r = (b[3] - a[3]) * h * h
    c3, c4, c5 = 10 * p - 4 * v + r / 2, -15 * p + 7 * v - r, 6 * p - 3 * v + r / 2
    s = u / h
    return a[1] + a[2] * u + a[3] * u * u / 2 + s**3 * (c3 + s * (c4 + s * c5))


def csv_knots(path):
    rows = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    return [tuple(float(cell) for cell in row.split(",")) for row in rows[1:]]


class Event(ctypes.Structure):
    _fields_ = [
        ("number", ctypes.c_int64), ("timestamp", ctypes.c_int64),
        ("channel_length", ctypes.c_int32), ("data_length", ctypes.c_int32),
        ("channel", ctypes.c_char_p), ("data", ctypes.c_void_p),
    ]


def lcm_events(path):
    """(channel, data) of each event, by LCM's own library."""
    lcm = ctypes.CDLL(ctypes.util.find_library("lcm"))
    lcm.lcm_eventlog_create.restype = ctypes.c_void_p
    lcm.lcm_eventlog_read_next_event.restype = ctypes.POINTER(Event)
    lcm.lcm_eventlog_read_next_event.argtypes = [ctypes.c_void_p]
    log = lcm.lcm_eventlog_create(str(path).encode(), b"r")
    assert log, "LCM does not open the log"
    events = []
    while event := lcm.lcm_eventlog_read_next_event(log):
        events.append((event.contents.channel, ctypes.string_at(event.contents.data, event.contents.data_length)))
    return events


def lcm_knots(path, repository, folder):
    subprocess.run(["lcm-gen", "-p", "--ppath", folder, repository / "io/lcm/table_file_t.lcm"], check=True,
                   stdout=subprocess.DEVNULL)
    sys.path.insert(0, str(folder))
    from jounce_table import table_file_t

    [(channel, data)] = lcm_events(path)
    assert channel == b"JOUNCE.table_file", channel
    table = table_file_t.decode(data)
    assert (table.axis, table.rule, table.outside) == ("master", "quintic_hermite", "wrap")
    assert (table.x_unit, table.position_unit) == ("deg", "mm")
    assert len(table.sha256) == 64 and table.made_by.startswith("jounce ")
    assert table.columns == 4 and table.knots == len(table.value[0])
    return list(zip(*table.value))


def text(content):
    (length,) = struct.unpack_from("<I", content)
    return content[4:4 + length].decode(), content[4 + length:]


def mcap_records(path):
    """(opcode, content) of each record."""
    data = path.read_bytes()
    magic = b"\x89MCAP0\r\n"
    assert data.startswith(magic) and data.endswith(magic)
    at, end, records = len(magic), len(data) - len(magic), []
    while at < end:
        opcode, length = struct.unpack_from("<BQ", data, at)
        records.append((opcode, data[at + 9:at + 9 + length]))
        at += 9 + length
    assert at == end, "the records end at the magic bytes"
    return records


def mcap_messages(path, columns):
    """(log time, knot) of each message. Requires the order of records that the format prescribes."""
    records = mcap_records(path)
    opcodes = [opcode for opcode, _ in records]
    assert opcodes[:3] == [0x01, 0x03, 0x04] and opcodes[-2:] == [0x0F, 0x02], opcodes
    assert set(opcodes[3:-2]) == {0x05}
    profile, rest = text(records[0][1])
    library, rest = text(rest)
    assert profile == "jounce-table" and library.startswith("jounce ") and not rest
    (schema,) = struct.unpack_from("<H", records[1][1])
    name, rest = text(records[1][1][2:])
    encoding, rest = text(rest)
    schema_text, rest = text(rest)
    assert schema != 0 and name and encoding == "jsonschema" and not rest
    assert list(json.loads(schema_text)["properties"]) == columns
    channel, of_schema = struct.unpack_from("<HH", records[2][1])
    topic, rest = text(records[2][1][4:])
    encoding, rest = text(rest)
    assert of_schema == schema and topic == "/jounce/table" and encoding == "json"
    (length,) = struct.unpack_from("<I", rest)
    assert length == len(rest) - 4
    metadata, rest = {}, rest[4:]
    while rest:
        key, rest = text(rest)
        metadata[key], rest = text(rest)
    messages = []
    for number, (_, content) in enumerate(records[3:-2]):
        of_channel, sequence, log_time, publish_time = struct.unpack_from("<HIQQ", content)
        assert of_channel == channel and sequence == number and log_time == publish_time
        values = json.loads(content[22:])
        assert list(values) == columns
        messages.append((log_time, tuple(values.values())))
    assert metadata["knots"] == str(len(messages))
    assert records[-2][1] == bytes(4) and records[-1][1] == bytes(20), "no CRC, no summary"
    return messages, metadata


def require_motion(knots):
    greatest, piece = 0, 0
    for i in range(PLACES + 1):
        x = 360 * i / PLACES
        while piece + 2 < len(knots) and x > knots[piece + 1][0]:
            piece += 1
        greatest = max(greatest, abs(quintic(knots[piece], knots[piece + 1], x) - motion_e(x)))
    assert greatest < 1e-9, f"{greatest} mm from the motion"


def main():
    jounce, repository = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def run(*arguments, status=0):
            run = subprocess.run([jounce, *map(str, arguments)], cwd=folder, capture_output=True, text=True)
            assert run.returncode == status, (arguments, run.returncode, run.stderr)
            return run.stdout

        (folder / "e.toml").write_text(SPEC)
        run("design", "e.toml", "-o", "e.csv")
        wanted = csv_knots(folder / "e.csv")
        for ending in ("lcmlog", "mcap"):
            run("convert", "e.csv", f"e.{ending}")
            assert "equal" in run("diff", "e.csv", f"e.{ending}")
            run("convert", f"e.{ending}", f"{ending}.csv")
            assert (folder / f"{ending}.csv").read_bytes() == (folder / "e.csv").read_bytes()
        knots = lcm_knots(folder / "e.lcmlog", repository, folder)
        assert knots == wanted
        require_motion(knots)
        messages, metadata = mcap_messages(folder / "e.mcap", ["master", "position", "geo_velocity", "geo_acceleration"])
        assert [knot for _, knot in messages] == wanted
        assert [time for time, _ in messages] == [i * 1_000_000 for i in range(len(wanted))]
        assert (metadata["axis"], metadata["x_unit"], metadata["outside"]) == ("master", "deg", "wrap")

        run("design", repository / "examples/hmpl-pvt/pvt.toml", "-o", "m.csv", status=1)  # leaves its range
        run("convert", "m.csv", "m.mcap")
        messages, metadata = mcap_messages(folder / "m.mcap", ["time", "position", "velocity"])
        motion = csv_knots(folder / "m.csv")
        assert [knot for _, knot in messages] == motion and metadata["axis"] == "time"
        in_ns = {"s": 1e9, "ms": 1e6}[metadata["x_unit"]]
        for (time, _), knot in zip(messages, motion):
            assert abs(time - (knot[0] - motion[0][0]) * in_ns) <= 0.5


if __name__ == "__main__":
    main()
