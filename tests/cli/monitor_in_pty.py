#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""monitor_in_pty.py JOUNCE AXIS CAM: the dashboard of `jounce monitor` in a terminal of its own, while the axis plays
the cam: what it shows, what its keys do, and that it leaves the terminal as it was. Ends within a minute."""
import fcntl
import os
import pty
import re
import select
import signal
import struct
import subprocess
import sys
import termios
import time

jounce, axis, cam = sys.argv[1:4]
signal.alarm(60)
try:
    for end in pty.openpty():
        os.close(end)
except OSError as error:
    print(f"skipped: there are no pseudo-terminals here ({error}); is /dev/pts mounted?")
    sys.exit(77)


class Monitor:
    def __init__(self, *words, rows=24, columns=80):
        self.out = b""
        self.pid, self.fd = pty.fork()
        if self.pid == 0:
            os.environ.update(TERM="xterm", LC_ALL="C.UTF-8")
            os.execv(jounce, [jounce, "monitor", *words])
        self.before = termios.tcgetattr(self.fd)
        self.resize(rows, columns)

    def resize(self, rows, columns):
        fcntl.ioctl(self.fd, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))

    def read(self):
        """False when it has ended."""
        if select.select([self.fd], [], [], 0.1)[0]:
            try:
                self.out += os.read(self.fd, 65536)
            except OSError:
                return False
        return True

    def screen(self):
        """The last whole picture, without colors."""
        pictures = self.out.split(b"\x1b[H")
        whole = [p for p in pictures[1:] if b"\x1b[J" in p]
        return re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", whole[-1].decode()) if whole else ""

    def wait_for(self, text):
        while True:
            alive = self.read()
            if re.search(text, self.screen()):
                return
            if not alive:
                sys.exit(f"FAILED: it ended without showing {text}:\n{self.screen()}")

    def press(self, keys):
        os.write(self.fd, keys)

    def end(self):
        while self.read():
            pass
        return os.waitstatus_to_exitcode(os.waitpid(self.pid, 0)[1])


def expect(good, what, shown=""):
    if not good:
        sys.exit(f"FAILED: {what}\n{shown}")


def too_late(*_):
    sys.exit(f"FAILED: too late; the screen:\n{monitor.screen()}")


signal.signal(signal.SIGALRM, too_late)
executor = subprocess.Popen([jounce, "run", axis, "--enable", "--watchdog", "30", "--seconds", "50"],
                            stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
try:
    monitor = Monitor()
    monitor.wait_for("> feeder .*standstill")
    subprocess.run([jounce, "stream", cam, "--to", "feeder"], check=True, stdout=subprocess.DEVNULL)
    monitor.wait_for("synchronized_motion")
    monitor.press(b"h")
    monitor.wait_for("feeder: hold accepted")
    monitor.press(b"r")
    monitor.wait_for("feeder: resume accepted")
    monitor.resize(12, 60)
    monitor.wait_for("q quit")
    monitor.resize(24, 80)
    monitor.press(b"s")
    monitor.wait_for("Stop feeder")
    monitor.press(b"y")
    monitor.wait_for("feeder: stop accepted")
    monitor.wait_for("standstill")
    monitor.wait_for("0 finished, 1 stopped")
    shown = monitor.screen()
    print(shown)
    lines = shown.split("\r\n")
    expect(len(lines) <= 24 and max(map(len, lines)) <= 80, "the picture is larger than the screen", shown)
    monitor.press(b"q")
    expect(monitor.end() == 0, "q ends it with another status than 0")
    expect(b"\x1b[?25h\x1b[?1049l" in monitor.out, "cursor and screen do not come back")

    # Every other end restores the terminal too.
    for how in (lambda m: m.press(b"\x03"), lambda m: os.kill(m.pid, signal.SIGTERM)):
        monitor = Monitor("feeder")
        monitor.wait_for("> feeder")
        how(monitor)
        expect(monitor.end() == 0, "it ends with another status than 0")
        expect(b"\x1b[?25h\x1b[?1049l" in monitor.out, "cursor and screen do not come back")

    monitor = Monitor("nobody", "--silence", "1")
    expect(monitor.end() == 3, "there is no executor, and the exit status is not 3")
    expect(b"nobody has sent no message for 1 s" in monitor.out, "it does not name the silent executor")
finally:
    executor.terminate()
    executor.wait()
