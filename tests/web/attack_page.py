#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Attacks a live page as another user of its machine could, and asks for Stop meanwhile:
attack_page.py ADDRESS_WITH_TOKEN EXECUTOR_PID [stop]; with `stop`: asks for Stop alone."""
import json
import os
import random
import socket
import sys
import threading
import time
import urllib.request

ADDRESS, TOKEN = sys.argv[1].split("#")
PORT = int(ADDRESS.split(":")[2].strip("/"))
PATIENCE = 120  # s: ends a test that hangs; a loaded machine is slow
HEAD = f"Host: 127.0.0.1:{PORT}\r\n"


def connect():
    return socket.create_connection(("127.0.0.1", PORT), timeout=PATIENCE)


def answer_of(connection):
    data = b""
    try:
        while chunk := connection.recv(65536):
            data += chunk
    except ConnectionResetError:
        pass
    return data


def stop(why):
    request = urllib.request.Request(ADDRESS + "order", json.dumps({"axis": "feeder", "what": "stop"}).encode(),
                                     {"X-Jounce-Token": TOKEN})
    with urllib.request.urlopen(request, timeout=PATIENCE) as answer:
        assert answer.status == 200, why


def memory(pid):
    """Resident, MB."""
    with open(f"/proc/{pid}/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6


def children(pid):
    found = []
    for process in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{process}/stat") as file:
                parent = int(file.read().rsplit(")", 1)[1].split()[1])
        except OSError:
            continue
        if parent == pid:
            found.append(int(process))
    return found


def endless_body(token):
    """Sends 64 MB in chunks, until the page hangs up; what it answered, and how much was sent."""
    connection = connect()
    head = f"POST /order HTTP/1.1\r\n{HEAD}Transfer-Encoding: chunked\r\n"
    connection.sendall((head + (f"X-Jounce-Token: {TOKEN}\r\n" if token else "") + "\r\n").encode())
    chunk, sent = b"10000\r\n" + b"x" * 65536 + b"\r\n", 0
    try:
        while sent < 64e6:
            connection.sendall(chunk)
            sent += len(chunk)
    except OSError:
        pass
    return answer_of(connection), sent


def slow(connections, end):
    """Requests that never end: a byte each second, on many connections, opened again where they are closed."""
    held = []
    while not end.is_set():
        while len(held) < connections:
            try:
                one = connect()
                one.sendall(f"POST /order HTTP/1.1\r\n{HEAD}".encode())
                held.append(one)
            except OSError:
                break
        for one in list(held):
            try:
                one.sendall(b"X")
            except OSError:
                held.remove(one)
        end.wait(0.2)


def readers(count):
    held = []
    for _ in range(count):
        one = connect()
        one.sendall(f"GET /events HTTP/1.1\r\n{HEAD}\r\n".encode())
        held.append(one)
    return held


def noise(seed):
    """Bytes of any kind, and requests with bytes turned over."""
    draw = random.Random(seed)
    good = (f"POST /order HTTP/1.1\r\n{HEAD}X-Jounce-Token: {TOKEN}\r\nContent-Length: 30\r\n\r\n"
            '{"axis":"feeder","what":"hop!"}').encode()
    for _ in range(300):
        data = bytearray(good) if draw.random() < 0.8 else bytearray(draw.randbytes(draw.randrange(1, 3000)))
        for _ in range(draw.randrange(8)):
            data[draw.randrange(len(data))] = draw.randrange(256)
        with connect() as connection:
            try:
                connection.sendall(bytes(data[:draw.randrange(1, len(data) + 1)]))
                connection.shutdown(socket.SHUT_WR)
                answer_of(connection)
            except OSError:
                pass


def main():
    stop("at first")
    if len(sys.argv) > 3:
        return
    page = children(int(sys.argv[2]))
    assert len(page) == 1, page
    before = memory(page[0])
    for token in (False, True):
        answer, sent = endless_body(token)
        assert b" 403 " in answer or b" 411 " in answer or not answer, answer[:200]
        assert sent < 16e6, f"{sent} bytes of a body were taken"
    strangers = readers(8)
    end = threading.Event()
    attack = threading.Thread(target=slow, args=(200, end))
    attack.start()
    try:
        time.sleep(2)
        for turn in range(20):
            stop(f"{turn} with 200 slow connections")
        # Eight strangers look; a page with the token is let in all the same.
        request = urllib.request.Request(ADDRESS + "events", headers={"X-Jounce-Token": TOKEN})
        with urllib.request.urlopen(request, timeout=PATIENCE) as events:
            assert events.status == 200 and events.readline().startswith(b"data: ")
    finally:
        end.set()
        attack.join()
    for one in strangers:
        one.close()
    seed = int(os.environ.get("SEED", 1))
    print("seed", seed)
    noise(seed)
    stop("after the noise")
    assert children(int(sys.argv[2])) == page, "the page has died"
    grown = memory(page[0]) - before
    print(f"the page took {before:.1f} MB before, {grown:.1f} more after")
    assert grown < 32, grown
    # A request has a time for all of it, however steadily its bytes come.
    request, one, taken = (f"GET / HTTP/1.1\r\n{HEAD}" + "X: y\r\n" * 500).encode(), connect(), 0
    try:
        for byte in request:
            one.sendall(bytes([byte]))
            time.sleep(0.05)
            taken += 1
    except OSError:
        pass
    assert taken < len(request), "a request of bytes that come one by one was never ended"
    stop("at last")


main()
