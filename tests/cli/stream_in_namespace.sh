#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# stream_in_namespace.sh JOUNCE EXAMPLES: `jounce stream` as an operator uses it, rightly and wrongly, and what the executor's
# logs show of it.
set -eu
. "$(dirname "$0")/namespace.sh"
jounce=$1
examples=$2
cd "$scratch"

axis() {  # axis NAME LIMITS [MORE]
  printf 'jounce = 1\nkind = "axis"\nname = "%s"\nunits = { position = "mm", master = "mm" }\n[axis]\ncycle = "1 ms"\nlongest_gap = "30 s"\nsession_timeout = "10 s"\n%b\n[limits]\n%b\n' \
    "$1" "${3:-}" "$2" > "$1.toml"
}
axis line 'velocity = 60000\nacceleration = 200000'
follow='[follow]\naxis = "line"'
axis carr 'velocity = 50000\nacceleration = 2000000' "$follow"
axis gear 'velocity = 50000\nacceleration = 2000000' "$follow"
axis slave 'velocity = 3000\nacceleration = 200000' "$follow"
axis x 'velocity = 500\nacceleration = 10000\nposition_min = 0\nposition_max = 300'
axis y 'velocity = 500\nacceleration = 10000'
axis shear 'velocity = 3000\nacceleration = 200000' "$follow"
axis knife 'velocity = 3000\nacceleration = 200000' "$follow"
sed -i 's/position = "mm", master = "mm"/position = "deg", master = "mm"/; s/^cycle/modulo = "360 deg"\ncycle/' knife.toml
for example in 7-6 7-7; do sed 's/"pulse"/"mm"/g' "$examples/googol-follow/$example.toml" > $example.toml; done
cat > gip.toml <<'END'
jounce = 1
kind = "gear"
units = { position = "mm", master = "mm" }
[gear]
engage = "position"
numerator = 1
denominator = 2
master_sync_position = 5000
slave_sync_position = 2000
master_start_distance = 4000
avoid_reversal = true
master_end = 10000
END
for mode in absolute ramp_in_neg ramp_in_pos; do
  cat > cam_$mode.toml <<END
jounce = 1
kind = "cam"
periodic = true
units = { master = "mm", position = "mm" }
start = { master = 0, slave = 0, geo_velocity = 0, geo_acceleration = 0 }
segment = [
  { law = "quintic", end = { master = 75, slave = 100, geo_velocity = 1, geo_acceleration = 0 } },
  { law = "quintic", end = { master = 200, slave = 225, geo_velocity = 1, geo_acceleration = 0 } },
  { law = "quintic", end = { master = 280, slave = 100, geo_velocity = 0.01739120485, geo_acceleration = 0 } },
  { law = "quintic", end = { master = 360, slave = 0, geo_velocity = 0, geo_acceleration = 0 } },
]
[coupling]
start = "$mode"
$([ $mode = absolute ] || printf 'velocity_diff = 150\nacceleration = 5000\n')
END
done
for cut in 250 300; do
  cat > knife$cut.toml <<END
jounce = 1
kind = "knife"
units = { position = "deg", master = "mm" }
[knife]
diameter = "100 mm"
cut_length = $cut
sync_angle = 20
END
done
for cut in 200 300; do
  cat > shear$cut.toml <<END
jounce = 1
kind = "shear"
units = { position = "mm", master = "mm" }
[shear]
cut_length = $cut
line_speed = 200
sync_time = 0.2
stroke = 100
[limits.slave]
velocity = 3000
acceleration = 10000
END
done
for range in 0-80 200-280; do
  from=${range%-*} to=${range#*-}
  cat > $range.toml <<END
jounce = 1
kind = "move"
units = { position = "mm" }
[move]
profile = "s_curve"
from = $from
to = $to
velocity = 200
acceleration = 2000
jerk = 50000
END
done

"$jounce" run line.toml carr.toml gear.toml slave.toml x.toml y.toml shear.toml knife.toml --enable --watchdog 30 --log run.csv --seconds 130 > run.txt 2>&1 &
executor=$!
trap 'kill $executor 2> /dev/null || true; sleep 0.5; rm -rf "$scratch"' EXIT
soon "$jounce" order line override 100% || fail "no executor: $(cat run.txt)"
stream() { timeout 20 "$jounce" stream "$@" > out.txt 2>&1; }
refused() {  # refused WHY TEXT ARGUMENTS: exit status 1, and TEXT in the output
  why=$1 text=$2
  shift 2
  status=0
  stream "$@" || status=$?
  [ $status = 1 ] || fail "$why: exit status $status: $(cat out.txt)"
  grep -q -- "$text" out.txt || fail "$why: prints $(cat out.txt)"
}
stands_at() {  # stands_at AXIS POSITION
  at=$(position "$1")
  awk -v a="$at" -v b="$2" 'BEGIN { exit !(a - b < 1e-6 && b - a < 1e-6) }' || fail "$1 stands at $at, not at $2"
}

# A queue begins at its own place, within the axis's range, or not at all.
refused "rolling from elsewhere" 'begins at 200 mm, but the axis is at 0 mm: send `jounce order x move --to 200mm`' 200-280.toml --to x --rolling --ahead 2
refused "banks from elsewhere" 'begins at 200 mm, but the axis is at 0 mm' 200-280.toml --to x --bank 0-80.toml
stands_at x 0
stream 0-80.toml --to x --rolling --ahead 2 || fail "rolling from its place: $(cat out.txt)"
stands_at x 80
stream 200-280.toml --to x --rolling --ahead 2 --relative || fail "relative: $(cat out.txt)"
stands_at x 160
refused "loops out of the range" 'position_limit.*320.*limit 300' 0-80.toml --to x --bank 0-80.toml --loops 1 --relative
stands_at x 160

# Several axes: all or none, all reasons, one tick.
refused "one of two stands elsewhere" 'x: rejected.*start_position' 0-80.toml --to y,x
grep -q 'y: .*not started, because x rejected its start' out.txt || fail "y is not named: $(cat out.txt)"
stands_at y 0
stream 200-280.toml --to x --rolling --ahead 2 --relative || fail "to 240: $(cat out.txt)"
refused "two reasons" 'x: rejected.*start_position' 200-280.toml --to x,y
grep -q 'y: rejected.*start_position' out.txt || fail "the second reason is missing: $(cat out.txt)"
"$jounce" order x move --to 0 > /dev/null
wait_for x standstill
stream 0-80.toml --to x,y || fail "together: $(cat out.txt)"
stands_at x 80
stands_at y 80

# Judged where it happens.
"$jounce" order slave move --to 125 > /dev/null
wait_for slave standstill
"$jounce" order line jog 200 > /dev/null
begin=$(position line | awk '{ print 100 + 360 * int($1 / 360 + 2) }')
stream cam_absolute.toml --to slave --live --start-at "$begin" || fail "judged at the wrong place: $(cat out.txt)"
grep -q started out.txt || fail "not started: $(cat out.txt)"
"$jounce" order slave halt > /dev/null
wait_for slave standstill
"$jounce" order slave move --to=-500 > /dev/null
wait_for slave standstill
begin=$(position line | awk '{ print 360 * int($1 / 360 + 3) }')
refused "the wrong direction" 'dropped.*would_reverse' cam_ramp_in_neg.toml --to slave --live --start-at "$begin"
begin=$(position line | awk '{ print int($1) + 600 }')
stream cam_ramp_in_pos.toml --to slave --live --start-at "$begin" || fail "the right direction: $(cat out.txt)"
"$jounce" order slave halt > /dev/null

# Another cut length from the next cut on: a knife behind the line at 200 mm/s.
begin=$(position line | awk '{ print 250 * int($1 / 250 + 4) }')
stream knife250.toml --to knife --live --start-at "$begin" || fail "the knife does not begin: $(cat out.txt)"
begin=$(position line | awk '{ print 200 * int($1 / 200 + 4) }')
stream shear200.toml --to shear --live --start-at "$begin" --no-wait || fail "the shear is not accepted: $(cat out.txt)"
grep -q 'accepted, waits for its start' out.txt || fail "--no-wait prints: $(cat out.txt)"
sleep 2
stream knife300.toml --to knife --live --at-next-cut || fail "no other length: $(cat out.txt)"
sleep 3
stream shear300.toml --to shear --live --at-next-cut || fail "no other length of the shear: $(cat out.txt)"
sleep 4
"$jounce" order knife halt > /dev/null
"$jounce" order shear halt > /dev/null
"$jounce" order line halt > /dev/null

# A follow spec with its tables, and a gear that stays in gear: both stand still when their master does.
"$jounce" order line set-position 0 > /dev/null || fail "the line does not count from 0"
stream 7-6.toml --to carr --live || fail "7-6: $(cat out.txt)"
stream gip.toml --to gear --live || fail "GearInPos: $(cat out.txt)"
stream 7-7.toml --to carr && fail "pass without a live master"
grep -q 'follow.pass = 50000: is a position of a live master: stream it with --live' out.txt || fail "prints $(cat out.txt)"
"$jounce" order line jog 10000 --acceleration 20000 > /dev/null
sleep 3
"$jounce" order line halt --deceleration 20000 > /dev/null
sleep 1.5
kill -INT $executor
wait $executor || fail "the executor ended badly: $(cat run.txt)"

# The evidence of the logs.
python3 - <<'END'
import csv, math
def log(axis):
    with open(f"run.{axis}.csv") as f:
        rows = list(csv.reader(f))[1:]
    return [(int(r[0]), r[2], float(r[3]), float(r[5]), float(r[6]), r[8]) for r in rows]
def shear(m):  # example 7-6: to ratio 1 in 5000, then the cycle
    if m < 5000: return 2500 * (m / 5000) ** 2
    n, u = divmod(m - 5000, 10000)
    p, at, ratio = 0, 0, 1
    for x, y in (1000, 1000), (4000, 3400), (6000, 4600), (9000, 7000), (10000, 8000):
        length, way = x - at, y - p
        end = 2 * way / length - ratio
        if u <= x:
            s = (u - at) / length
            return 2500 + 8000 * n + p + ratio * length * s + (end - ratio) * length * s * s / 2
        p, at, ratio = y, x, end
def gear(m):  # PMC600 6.2: at half the master's speed from (5000, 2000) on
    return 2000 + (m - 5000) / 2 if m >= 5000 else None
end = log("line")[-1]
assert end[3] > 20000 and end[4] == 0, f"the line is at {end[3]}"
for axis, exact in ("carr", shear), ("gear", gear):
    tail = [row for row in log(axis) if row[1] == "synchronized_motion"][-4000:]
    assert len(tail) > 200 and tail[-1][2] > 20000, f"{axis}: {len(tail)} ticks in step, at last {log(axis)[-1]}"
    for tick, state, m, p, v, job in tail:
        want = exact(m) if m > 0 else None
        assert want is None or abs(p - want) < 1e-4, f"{axis} at tick {tick}: {p} at {m}, not {want}"
    assert tail[-1][4] == 0, f"{axis} runs on at {tail[-1][4]}"
# A cut: any tick at the line's speed, from which the cut is extrapolated. A late cycle can leave all of them out.
ratio = 360 / (math.pi * 100)  # deg of the knife per mm of the line
cuts = {}
for tick, state, m, p, v, job in log("knife"):
    k = round(p / 360)
    if state == "synchronized_motion" and abs(v - 200 * ratio) < 1e-3 and abs(p - 360 * k) < 10:
        cuts[k] = m - (p - 360 * k) / ratio
lengths = [round(cuts[k + 1] - cuts[k], 1) for k in sorted(cuts) if k + 1 in cuts]
cuts, before = [None], 0
for tick, state, m, p, v, job in log("shear"):
    if tick - before > 150: cuts.append(None)
    if state == "synchronized_motion" and abs(v - 200) < 1e-3 and (cuts[-1] is None or m - p > cuts[-1] + 50):
        cuts.append(m - p)
    before = tick
pieces = [round(b - a, 1) for a, b in zip(cuts, cuts[1:]) if a is not None and b is not None]
assert 200.0 in pieces and pieces[-1] == 300.0 and sorted(pieces) == pieces and set(pieces) <= {200.0, 300.0}, pieces
assert 250.0 in lengths and lengths[-1] == 300.0 and sorted(lengths) == lengths and set(lengths) <= {250.0, 300.0}, lengths
END
