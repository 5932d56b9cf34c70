#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# follow_in_namespace.sh JOUNCE EXAMPLES: examples 7-7 and 7-9 of the Googol manual, a table that only a forward master
# moves, and a table that ends at a ratio, streamed to an executor. judge_follow.py compares the logs and the events with
# the manual's numbers.
set -eu
. "$(dirname "$0")/namespace.sh"
jounce=$1
judge="$root/tests/cli/judge_follow.py"
examples=$2/googol-follow
cd "$scratch"

axis() {  # axis NAME MASTER: follows that axis or master
  cat > "$1.toml" <<END
jounce = 1
kind = "axis"
name = "$1"
units = { position = "pulse", master = "pulse" }
[axis]
cycle = "1 ms"
longest_gap = "30 s"
session_timeout = "10 s"
[limits]
velocity = 60000
acceleration = 2000000
END
  printf '[[axis]]\nspec = "%s.toml"\n%s\n' "$1" "${2:+follow = { $2 \}}" >> machine.toml
}
cat > machine.toml <<'END'
jounce = 1
kind = "machine"
[master.line]
kind = "external"
unit = "pulse"
velocity = 60000
acceleration = 2000000
longest_age = "5 s"
END
for name in web shear; do
  cp "$examples/$name.toml" .
  patient $name.toml
  printf '[[axis]]\nspec = "%s.toml"\n' $name >> machine.toml
done
axis open 'axis = "web"'
axis roll
axis back 'axis = "roll"'
axis bridge 'master = "line"'
move() {  # move NAME DISTANCE: the manual's master, 50 pulse/ms by 1 pulse/ms^2
  cat > "$1.toml" <<END
jounce = 1
kind = "move"
units = { position = "pulse" }
[move]
profile = "trapezoid"
to = $2
velocity = 50000
acceleration = 1000000
END
}
move once 180000
move far 330000
cat > open.toml.follow <<'END'
jounce = 1
kind = "follow"
units = { position = "pulse", master = "pulse" }
segment = [{ master = 20000, slave = 10000 }]
END

"$jounce" monitor shear --events --json --seconds 100 > events.json 2>&1 &
monitor=$!
"$jounce" run machine.toml --enable --watchdog 30 --log run.csv --record run.lcmlog --seconds 60 > run.txt 2>&1 &
executor=$!
"$jounce" master far.toml --as line --before 8 --after 40 > line.txt 2>&1 &
line=$!
trap 'kill $executor $line $monitor 2> /dev/null || true; sleep 0.5; rm -rf "$scratch"' EXIT
soon "$jounce" order web override 100% || fail "no executor: $(cat run.txt)"
sees_line() { "$jounce" monitor bridge --seconds 0.3 --json 2> /dev/null | grep -q '"master_name":"line".*"lost":false'; }
soon sees_line || fail "the line sends no position: $(cat line.txt run.txt)"
timeout 20 "$jounce" stream "$examples/7-9.toml" --to bridge --live > 7-9.txt 2>&1 || fail "7-9: $(cat 7-9.txt run.txt line.txt)"
timeout 20 "$jounce" stream open.toml.follow --to open --live > open.txt 2>&1 || fail "open: $(cat open.txt)"
timeout 20 "$jounce" stream "$examples/7-7.toml" --to shear --live > 7-7.txt 2>&1 &
waits=$!
timeout 20 "$jounce" stream "$examples/7-7.toml" --to open > refused.txt 2>&1 && fail "pass without a live master"
wait_for shear '"progress":"waiting"'
timeout 20 "$jounce" stream once.toml --to web > web.txt 2>&1 || fail "web: $(cat web.txt)"
wait $waits || fail "7-7: $(cat 7-7.txt)"
grep -q 'started' 7-7.txt || fail "7-7 does not report that it follows: $(cat 7-7.txt)"
timeout 20 "$jounce" stream "$examples/forwards.toml" --to back --live > forwards.txt 2>&1 ||
  fail "forwards: $(cat forwards.txt)"
for place in 60000 10000 140000; do # it turns at the ratio 0
  "$jounce" order roll move --to $place > roll.txt 2>&1 || fail "roll: $(cat roll.txt)"
  wait_for roll "\"standstill\".*\"position\":$place"
done
soon past bridge 201000 || fail "7-9 ends too early: $(cat "$scratch/status")"
wait_for web standstill
wait_for open standstill
kill -INT $executor
wait $executor || fail "the executor ended badly: $(cat run.txt)"
kill -INT $line

kill -INT $monitor
wait $monitor || true

"$jounce" replay run.lcmlog > replay.txt 2>&1 || fail "the replay differs: $(cat replay.txt)"
python3 "$judge" 7-7 run.shear.csv events.json || fail "the shear of 7-7"
python3 "$judge" 7-9 run.bridge.csv || fail "the tables of 7-9"
python3 "$judge" forwards run.back.csv || fail "the table that only a forward master moves"
python3 - <<'END'
import csv
def log(axis):
    with open(f"run.{axis}.csv") as f:
        rows = list(csv.reader(f))[1:]
    assert all(r[9] == "none" for r in rows), f"{axis}: {[r for r in rows if r[9] != 'none'][0]}"
    return [(int(r[0]), r[2], float(r[3]), float(r[4]), float(r[5]), float(r[6])) for r in rows]

# 7-7: the master is at 50000 at 1025 ms; then passes of 1200 ms and 40000 pulses, at most 50 pulse/ms.
rows = [r for r in log("shear") if r[1] == "synchronized_motion"]
assert rows[-1][4] > 80000, f"the shear is at {rows[-1][4]}"
cruise = [r for r in rows if abs(r[3] - 50000) < 1e-6]
start = round(cruise[0][0] - (cruise[0][2] / 50 + 25))
assert all(abs(r[0] - start - 25 - r[2] / 50) < 1e-6 for r in cruise), "the master is not the manual's"
for tick, state, m, mv, p, v in rows:
    assert (p > 0) == (tick > start + 1025), f"begun at {tick - start} ms"
    if tick == start + 1025 + 1200: assert abs(p - 40000) < 1e-6 and abs(v) < 1e-3, (p, v)
assert abs(max(r[5] for r in rows) - 50000) < 1e-6
# 7-9: at 50 pulse/ms the last table swings between 30 and 50. Late cycles may leave out both ends.
rows = [r for r in log("bridge") if r[1] == "synchronized_motion"]
assert rows[-1][4] > 200000, f"the bridge is at {rows[-1][4]}"
last = [v / mv for tick, state, m, mv, p, v in rows if m > 120000 and mv > 10000]
assert 0.6 - 1e-3 < min(last) < 0.62 and 0.98 < max(last) < 1 + 1e-9, (min(last), max(last))
# The table that ends at a ratio: the axis brakes within its limits, without a fault.
rows = log("open")
assert rows[-1][1] == "standstill" and rows[-1][5] == 0
speed = max(r[5] for r in rows)
for a, b in zip(rows, rows[1:]):
    assert abs(b[5] - a[5]) <= 2000 * (b[0] - a[0]) * (1 + 1e-9), f"{b[5] - a[5]} in a tick at {b[0]}"
assert speed <= 50000 * (1 + 1e-9)
brakes = speed ** 2 / 2 / 2e6
latest = max(b[0] - a[0] for a, b in zip(rows, rows[1:])) / 1000
assert 10000 + brakes <= rows[-1][4] + 1e-6 <= 10000 + brakes + max(0.1, latest) * speed, rows[-1][4]
END
