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
sed -i 's/^cycle.*/&\nlongest_gap = "900 ms"\nsession_timeout = "3 s"/' x.toml y.toml
"$jounce" run machine.toml --enable --log run.csv --record run.lcmlog --seconds 100 2> said &
executor=$!
for i in 1 2 3 4 5 6 7 8 9 10; do "$jounce" order plotter enable > /dev/null 2>&1 && break; sleep 0.3; done

order() { "$jounce" order "$@" > out 2>&1; }
refused() {  # refused WORDS ARGUMENTS...
  words=$1
  shift
  got=0
  order "$@" || got=$?
  [ $got = 1 ] || fail "$*: exit status $got, not 1: $(cat out)"
  grep -q -- "$words" out || fail "$*: not '$words': $(cat out)"
}

refused in_group x move --to 10mm
refused single_axis plotter move --to 10mm
order plotter start || fail "start: $(cat out)"
sleep 0.5
order plotter hold || fail "hold: $(cat out)"
refused in_motion plotter start
sleep 0.5
"$jounce" monitor plotter --json --seconds 1 | grep -q '"held":true' || fail "not held on the monitor"
order plotter override 200% || fail "override: $(cat out)"
order plotter resume || fail "resume: $(cat out)"
sleep 5

# Single commands, on the path of judge_group.py.
tick() { "$jounce" monitor plotter --json --seconds 0.2 | grep -o '"tick":[0-9]*' | tail -1 | cut -d: -f2; }
order plotter override 100% || fail "override: $(cat out)"
refused in_group x override 50%
refused 'to is missing' plotter move-linear --to ,
refused 'has no length' plotter move-linear --to 0,0
got=0
order x move-linear x=5 || got=$?
[ $got = 2 ] && grep -q 'must be a group' out || fail "a coordinate of a single axis: $got, $(cat out)"
got=0
order plotter move-linear z=5 || got=$?
[ $got = 2 ] && grep -q 'names z, but the axes of the group are x, y' out || fail "an unknown axis: $got, $(cat out)"
refused 'to has 3 coordinates, but the group has 2 axes' plotter move-linear --to 0,0,5
refused 'position_max' plotter move-linear --to 1000000000,0
refused 'needs a buffer mode that blends' plotter move-linear --to 5,5 --deviation 1
refused 'via must be given' plotter move-circular --to 5,5
refused radius plotter move-circular --to 50,0 --radius 2
got=0
order plotter move-linear --to nan,1 || got=$?
[ $got = 2 ] || fail "a coordinate nan: exit status $got: $(cat out)"
first=$(tick)
order plotter wait 1 || fail "wait: $(cat out)"
order plotter move-linear y=10mm x=20mm --velocity 40 || fail "move-linear: $(cat out)"
order plotter move-linear --to 40,10 --velocity 30 --blend look-ahead --deviation 1 || fail "move-linear: $(cat out)"
order plotter move-circular x=40 y=30 --center x=40,y=20 --velocity 30 --buffered || fail "move-circular: $(cat out)"
order plotter move-linear --by -40,0 --velocity 30 --buffered || fail "move-linear --by: $(cat out)"
order plotter move-direct --to 0,0 --blend look-ahead --deviation 1 || fail "move-direct: $(cat out)"
"$jounce" monitor plotter --json --seconds 0.2 | grep -q '"queue_rows":[1-9]' || fail "no command waits on the monitor"
sleep 6
last=$(tick)

order plotter jog --along 1,1 --velocity 20 --hold-to-run --seconds 0.5 || fail "jog: $(cat out)"
order plotter jog --along -1,-1 --velocity 20 || fail "jog back: $(cat out)"
sleep 1
order plotter move-linear --to 0,0 || fail "move-linear: $(cat out)"
sleep 1
sed '/^\[\[command/,$d' square.toml > bed.toml
printf 'G21 G90 G64 P0.1\nG1 X20 Y0 F3000\nG1 X20 Y10\nG1 X0 Y0\nM30\n' > part.ngc
"$jounce" stream part.ngc --machine bed.toml --to plotter > out 2>&1 || fail "stream G-code: $(cat out)"
order plotter move-linear x=5 y=5 --velocity 50 --buffered || fail "after a path: $(cat out)"
order plotter move-linear x=0 y=0 --velocity 50 --blend look-ahead || fail "after a path: $(cat out)"
"$jounce" monitor plotter --json --seconds 0.5 | grep -q '"path_length":[0-9].*"remaining":[0-9].*"commands":[1-9]' ||
  fail "no place on the path"
sleep 3

"$jounce" stream square.toml --to plotter > out 2>&1 || fail "stream: $(cat out)"
sleep 0.3
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
sleep 2
order plotter enable || fail "enable: $(cat out)"
"$jounce" stream square.toml --to plotter > out 2>&1 || fail "stream: $(cat out)"
sleep 0.3
order y disable || fail "disable y: $(cat out)"
sleep 0.5
"$jounce" monitor plotter --json --seconds 1 | grep -q '"error_stop"' || fail "no fault of the group"

kill -INT $executor
wait $executor || [ $? = 1 ] || fail "the run: $(cat said)"
for name in x y plotter; do [ -s run.$name.csv ] || fail "no log of $name"; done
grep -q ',synchronized_motion,' run.x.csv || fail "x did not follow its group"
python3 "$here/judge_group.py" run.x.csv run.y.csv run.plotter.csv "$first" "$last" || fail "the judge of the log"
"$jounce" replay run.lcmlog > out || fail "the replay: $(cat out)"
