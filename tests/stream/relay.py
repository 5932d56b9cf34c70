#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""relay.py PORT_A PORT_B SECONDS SEED NAME=SHARE...: joins two links of the loopback interface, group 239.255.76.67 on
PORT_A and on PORT_B, and passes real datagrams from each to the other. SHARE is the probability from 0 to 1 that a
datagram is lost, doubled, corrupted (one bit) or delayed (up to 5 ms, so that later ones overtake it). Prints
"ready" when it has joined, and at its end, after SECONDS or SIGTERM, one line of JSON with what it has done."""
import heapq
import json
import random
import select
import signal
import socket
import sys
import time

GROUP, LOOPBACK, LONGEST_DELAY = "239.255.76.67", "127.0.0.1", 0.005


def link(port):
    """The sockets that receive from a link and that send to it."""
    receiver = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    receiver.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    receiver.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 22)
    receiver.bind((GROUP, port))
    membership = socket.inet_aton(GROUP) + socket.inet_aton(LOOPBACK)
    receiver.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
    receiver.setblocking(False)
    sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(LOOPBACK))
    sender.bind((LOOPBACK, 0))
    return receiver, sender


def corrupted(data, draw):
    bit = draw.randrange(8 * len(data))
    broken = bytearray(data)
    broken[bit // 8] ^= 1 << bit % 8
    return bytes(broken)


def main():
    ports, seconds, seed = [int(p) for p in sys.argv[1:3]], float(sys.argv[3]), int(sys.argv[4])
    share = dict.fromkeys(("lost", "doubled", "corrupted", "delayed"), 0.0)
    for word in sys.argv[5:]:
        name, value = word.split("=")
        if name not in share:
            sys.exit(f"{name}: must be one of {', '.join(share)}")
        share[name] = float(value)
    draw = random.Random(seed)
    links = [link(port) for port in ports]
    own = {sender.getsockname() for _, sender in links}
    done = dict.fromkeys(("passed", *share), 0)
    held, number, end = [], 0, time.monotonic() + seconds

    def happens(what):
        yes = draw.random() < share[what]
        done[what] += yes
        return yes

    def stop(*_):
        nonlocal end
        end = 0

    signal.signal(signal.SIGTERM, stop)
    print("ready", flush=True)
    while (now := time.monotonic()) < end:
        while held and held[0][0] <= now:
            _, _, to, data = heapq.heappop(held)
            links[to][1].sendto(data, (GROUP, ports[to]))
            done["passed"] += 1
        wait = min(held[0][0] - now if held else 0.05, end - now)
        for receiver in select.select([r for r, _ in links], [], [], max(wait, 0))[0]:
            to = 1 if receiver is links[0][0] else 0
            for _ in range(64):
                try:
                    data, source = receiver.recvfrom(65536)
                except BlockingIOError:
                    break
                if source in own or happens("lost"):
                    continue
                for _ in range(2 if happens("doubled") else 1):
                    copy = corrupted(data, draw) if happens("corrupted") else data
                    due = time.monotonic() + (draw.uniform(0, LONGEST_DELAY) if happens("delayed") else 0)
                    number += 1
                    heapq.heappush(held, (due, number, to, copy))
    print(json.dumps(done), flush=True)


main()
