#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# group_in_namespace.sh JOUNCE EXAMPLE: the plotter of the examples as an operator uses it: start, hold, stream, stop,
# single commands, jogs, rejections, and what the log and a replay show of it.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/namespace.sh"
jounce=$1
example=$2
cd "$scratch"
cp "$example"/*.toml .
patient x.toml y.toml
"$jounce" run machine.toml --enable --watchdog 30 --log run.csv --record run.lcmlog --seconds 110 2> said &
executor=$!
soon "$jounce" order plotter enable || fail "no executor: $(cat said)"


refused 1 'the enabled group plotter alone moves this axis' x move --to 10mm
refused 1 single_axis plotter move --to 10mm
order plotter override 40% || fail "override: $(cat out)" # the path lasts 10 s, so that each command finds it in motion
order plotter start || fail "start: $(cat out)"
soon past plotter 10 || fail "it does not move"
order plotter hold || fail "hold: $(cat out)"
refused 1 "the group is held on its path" plotter start
wait_for plotter '"held":true'
order plotter override 200% || fail "override: $(cat out)"
order plotter resume || fail "resume: $(cat out)"
wait_for plotter '"state":"standstill"'

# Single commands, on the path of judge_group.py.
tick() {
  wait_for plotter '"tick":'
  sed 's/.*"tick":\([0-9]*\).*/\1/' "$scratch/status"
}
order plotter override 100% || fail "override: $(cat out)"
refused 1 'the enabled group plotter alone moves this axis' x override 50%
refused 1 'the command has no coordinate: give at least one' plotter move-linear --to ,
refused 1 'the path already ends at (0, 0)' plotter move-linear x=0
got=0
order x move-linear x=5 || got=$?
[ $got = 2 ] && grep -q 'is a single axis, without coordinates' out || fail "a coordinate of a single axis: $got, $(cat out)"
got=0
order plotter move-linear z=5 || got=$?
[ $got = 2 ] && grep -q 'names z, but the axes of the group are x, y' out || fail "an unknown axis: $got, $(cat out)"
refused 1 'has 3 coordinates, but the group has 2 axes' plotter move-linear --to 0,0,5
refused 1 'position_max' plotter move-linear --to 1000000000,0
refused 1 'needs a buffer mode that blends' plotter move-linear --to 5,5 --deviation 1
refused 1 'needs exactly one of --via, --center and --radius' plotter move-circular --to 5,5
refused 1 radius plotter move-circular --to 50,0 --radius 2
got=0
order plotter move-linear --to nan,1 || got=$?
[ $got = 2 ] || fail "a coordinate nan: exit status $got: $(cat out)"
first=$(tick)
order plotter wait 3 || fail "wait: $(cat out)"
order plotter move-linear y=10mm x=20mm --velocity 40 || fail "move-linear: $(cat out)"
order plotter move-linear --to 40,10 --velocity 30 --blend look-ahead --deviation 1 || fail "move-linear: $(cat out)"
order plotter move-circular x=40 y=30 --center x=40,y=20 --velocity 30 --buffered || fail "move-circular: $(cat out)"
order plotter move-linear --by -40,0 --velocity 30 --buffered || fail "move-linear --by: $(cat out)"
order plotter move-direct --to 0,0 --blend look-ahead --deviation 1 || fail "move-direct: $(cat out)"
wait_for plotter '"queue_rows":[1-9]'
wait_for plotter '"state":"standstill".*"queue_rows":0'
last=$(tick)

# Without speed, a motion waits. Its end by disable is no fault.
order plotter override 0% || fail "override: $(cat out)"
order plotter move-linear --by 5,0 --velocity 30 || fail "move-linear: $(cat out)"
grep -q 'accepted; the override is 0 %, so nothing moves' out || fail "no remark: $(cat out)"
wait_for plotter '"state":"discrete_motion"'
order plotter resume || fail "resume: $(cat out)"
grep -q 'accepted; the override is 0 %, so nothing moves' out || fail "no remark: $(cat out)"
order plotter disable || fail "disable: $(cat out)"
grep -q '^plotter: disable accepted; the motion that stood still is dropped$' out || fail "no remark: $(cat out)"
wait_for plotter '"state":"disabled".*"reason":"stopped"'
order plotter enable || fail "enable: $(cat out)"
order plotter override 100% || fail "override: $(cat out)"

order plotter jog --along 1,1 --velocity 20 --hold-to-run --seconds 0.5 || fail "jog: $(cat out)"
order plotter jog --along -1,-1 --velocity 20 || fail "jog back: $(cat out)"
sleep 1
order plotter move-linear --to 0,0 || fail "move-linear: $(cat out)"
wait_for plotter '"state":"standstill"'
sed '/^\[\[command/,$d' square.toml > bed.toml
printf 'G21 G90 G64 P0.1\nG1 X20 Y0 F900\nG1 X20 Y10\nG1 X0 Y0\nM30\n' > part.ngc
"$jounce" stream part.ngc --machine bed.toml --to plotter > out 2>&1 || fail "stream G-code: $(cat out)"
order plotter move-linear x=5 y=5 --velocity 5 --buffered || fail "after a path: $(cat out)"
order plotter move-linear x=0 y=0 --velocity 5 --blend look-ahead || fail "after a path: $(cat out)"
on_path() {
  "$jounce" monitor plotter --json --seconds 0.3 | grep -q '"path_length":[0-9].*"remaining":[0-9].*"commands":[1-9]'
}
soon on_path || fail "no place on the path"
wait_for plotter '"state":"standstill"'

order plotter override 40% || fail "override: $(cat out)"
"$jounce" stream square.toml --to plotter > out 2>&1 || fail "stream: $(cat out)"
soon past x 10 || fail "it does not move"
"$jounce" stop plotter > out 2>&1 || fail "stop: $(cat out)"
got=0
"$jounce" stream square.toml --to plotter > out 2>&1 || got=$?
[ $got = 1 ] || fail "a start elsewhere: exit status $got: $(cat out)"
grep -q 'x is at' out || fail "a start elsewhere: $(cat out)"
got=0
"$jounce" stream square.toml --to x > out 2>&1 || got=$?
[ $got = 1 ] && grep -q not_a_group out || fail "a path for one axis: $got, $(cat out)"
order plotter disable || fail "disable: $(cat out)"
for axis in x y; do order $axis move --to 0 || fail "move back: $(cat out)"; done
for axis in x y; do wait_for $axis '"state":"standstill".*"position":0\.0,'; done
order plotter enable || fail "enable: $(cat out)"
"$jounce" stream square.toml --to plotter > out 2>&1 || fail "stream: $(cat out)"
soon past x 10 || fail "it does not move"
order y disable || fail "disable y: $(cat out)"
wait_for plotter '"state":"error_stop"'

kill -INT $executor
wait $executor || [ $? = 1 ] || fail "the run: $(cat said)"
for name in x y plotter; do [ -s run.$name.csv ] || fail "no log of $name"; done
grep -q ',synchronized_motion,' run.x.csv || fail "x did not follow its group"
python3 "$here/judge_group.py" run.x.csv run.y.csv run.plotter.csv "$first" "$last" || fail "the judge of the log"
"$jounce" replay run.lcmlog > out || fail "the replay: $(cat out)"
