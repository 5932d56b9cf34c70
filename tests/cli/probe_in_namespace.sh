#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# probe_in_namespace.sh JOUNCE EXAMPLE DRIVE: examples/drive-shm in two processes. The process DRIVE latches the edges of
# its marks as objects of CiA 402; the touch probe of the axis in the executor captures them from shared memory.
set -eu
. "$(dirname "$0")/namespace.sh"
jounce=$1
drive=$3
name=slide-$$
cd "$scratch"
sed "s/^name = \"slide\"  .*/name = \"$name\"/" "$2/axis.toml" > axis.toml
grep -q "^name = \"$name\"" axis.toml || fail "the example has no name of a drive"
patient axis.toml
printf 'silent_cycles = 20000\n' >> axis.toml

"$jounce" monitor slide --events --json --seconds 100 > events.json 2>&1 &
monitor=$!
"$jounce" run axis.toml --enable --log run.csv --record run.lcmlog --seconds 90 > run.txt 2>&1 &
executor=$!
"$drive" "$name" 90 > drive.txt 2>&1 &
process=$!
trap 'kill $executor $process $monitor 2> /dev/null || true; sleep 0.5; rm -rf "$scratch"' EXIT
wait_for slide '"state":"standstill"'
"$jounce" order slide touch-probe 2 > refused.txt 2>&1 && fail "the drive has one touch probe"
grep -q no_trigger_input refused.txt || fail "input 2: $(cat refused.txt)"

# Forwards, with a window behind the first mark; then backwards, with single captures.
"$jounce" order slide touch-probe 1 --edge both --count 0 --first-position 50mm > order.txt 2>&1 || fail "$(cat order.txt)"
"$jounce" order slide move --to 150 > order.txt 2>&1 || fail "$(cat order.txt)"
wait_for slide '"standstill".*"position":150'
"$jounce" order slide abort-trigger 1 > order.txt 2>&1 || fail "$(cat order.txt)"
"$jounce" order slide touch-probe 1 > order.txt 2>&1 || fail "$(cat order.txt)"
"$jounce" order slide move --to 20 > order.txt 2>&1 || fail "$(cat order.txt)"
wait_for slide '"standstill".*"position":20'
kill -INT $executor
wait $executor || fail "the executor ended badly: $(cat run.txt)"
wait $process || fail "the drive ended badly: $(cat drive.txt)"
kill -INT $monitor
wait $monitor || true
"$jounce" replay run.lcmlog > replay.txt 2>&1 || fail "the replay differs: $(cat replay.txt)"

python3 - <<'END'
import csv, json, re
# Marks from 40 k to 40 k + 4 mm. A forward axis enters them at 40 k; a backward one at 40 k + 4.
want = [("+", 80.0), ("-", 84.0), ("+", 120.0), ("-", 124.0), ("+", 124.0)]
with open("run.csv", newline="") as file:
    reader = csv.reader(file)
    names = [name.split(" ")[0] for name in next(reader)]
    rows = [dict(zip(names, row)) for row in reader]
assert all(row["fault"] == "none" for row in rows)
seen = []
for row in rows:
    for word in row["captures"].split():
        edge, age, place = re.fullmatch(r"1([+-])@(.+)=(.+)", word).groups()
        seen.append((edge, float(place)))
assert seen == want, seen
with open("events.json") as file:
    events = [json.loads(line) for line in file if '"event"' in line]
told = [("+" if one["on"] else "-", one["position"]) for one in events]
assert told == want and all(one["kind"] == "probe" and one["number"] == 1 for one in events), events
assert [one["event"] for one in events] == [1, 2, 3, 4, 5]
END
