#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# group_in_namespace.sh JOUNCE EXAMPLE: the plotter of the examples as an operator uses it: start, hold, stream, stop,
# rejections, and what the log and a replay show of it.
set -eu
. "$(dirname "$0")/namespace.sh"
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
"$jounce" stream square.toml --to plotter > out 2>&1 || fail "stream: $(cat out)"
sleep 0.3
"$jounce" stop plotter > out 2>&1 || fail "stop: $(cat out)"
got=0
"$jounce" stream square.toml --to plotter > out 2>&1 || got=$?
[ $got = 1 ] || fail "a start elsewhere: exit status $got: $(cat out)"
grep -q 'axis 1 of the group: it stands at' out || fail "a start elsewhere: $(cat out)"
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
"$jounce" replay run.lcmlog > out || fail "the replay: $(cat out)"
