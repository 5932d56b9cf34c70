#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# home_in_namespace.sh JOUNCE EXAMPLE: `jounce order AXIS home` as an operator uses it, rightly and wrongly, on the
# example's slide; what the monitor, the log and a replay show of it.
set -eu
. "$(dirname "$0")/namespace.sh"
jounce=$1
example=$2
cd "$scratch"
cp "$example" slide.toml
patient slide.toml
sed 's/^name = .*/name = "bare"/; /^\[drive/,$d; /^require_home/d; /^\[homing\]/,/^distance/d' slide.toml > bare.toml
"$jounce" run slide.toml bare.toml --enable --watchdog 30 --log run.csv --record run.lcmlog --seconds 100 2> said &
executor=$!
soon "$jounce" order bare enable || fail "no executor: $(cat said)"


# The remedy of a rejected table names the axis.
"$jounce" new move -o move.toml
order bare disable || fail "disable: $(cat out)"
"$jounce" stream move.toml --to bare > out 2>&1 && fail "a table for a disabled axis"
grep -q 'rejected: not_enabled: The axis is disabled. Enable it: `jounce order bare enable`.' out ||
  fail "no remedy: $(cat out)"
order bare enable || fail "enable: $(cat out)"

# before it is homed
refused 1 not_homed slide move --to 10mm
order slide move --by 1mm || fail "a move by a distance: $(cat out)"

# monitor --until: the state of all axes, without it in time, with a fault, wrongly
"$jounce" monitor slide bare --until standstill --seconds 60 > out || fail "not at rest: $(cat out)"
grep -q '^bare .*standstill' out && grep -q '^slide .*standstill' out || fail "a status of each axis: $(cat out)"
# until STATUS WORDS ARGUMENTS...: the monitor ends with this exit status and prints these words.
until_() {
  wanted=$1
  words=$2
  shift 2
  got=0
  "$jounce" monitor "$@" > out 2>&1 || got=$?
  [ $got = "$wanted" ] && grep -q -- "$words" out || fail "monitor $*: exit status $got, not $wanted, or not '$words': $(cat out)"
}
until_ 1 'slide is in the state standstill, not homing' slide --until homing --seconds 0.5
until_ 2 'until requires NAME' --until standstill
until_ 2 'did you mean standstill' slide --until standstil
until_ 2 'until cannot be combined with --events' slide --until standstill --events
until_ 3 'nobody has sent no message' nobody --until standstill --seconds 0.5
refused 2 'method = 99.*must be 1 to 14' slide home --method 99
refused 1 no_such_method slide home --method 15
refused 2 'search-velocity = 0.*must be greater than 0' slide home --search-velocity 0
refused 2 'index-velocity = -1.*must be greater than 0' slide home --index-velocity -1
refused 2 'timeout = 0.*must be greater than 0' slide home --timeout 0
refused 2 'distance = 0.*must be greater than 0' slide home --distance 0
refused 1 velocity_limit slide home --search-velocity 5m/s
refused 2 'VALUE = 12.*does not apply to home' slide home 12
refused 2 'method = 3.*does not apply to move' slide move --to 3 --method 3
refused 2 'direction = positive.*does not apply to move --by' slide move --by 1mm --direction positive
refused 2 'at = 5.*waits until the axis is homed' slide home --at 5
refused 1 no_sensor bare home --method 24
wait_for slide '"homed":false'

# orders and faults that end it
refused 1 'not homed: home_timeout' slide home --timeout 100ms
order slide reset || fail "reset: $(cat out)"
refused 1 'not homed: search_distance: The search moved its whole distance.*--distance' slide home --distance 5mm
order slide reset || fail "reset: $(cat out)"
"$jounce" order slide home --search-velocity 2mm/s > slow 2>&1 &
slow=$!
wait_for slide '"state":"homing"'
refused 1 busy slide home
"$jounce" stop slide > out 2>&1 || fail "stop: $(cat out)"
status=0
wait $slow || status=$?
[ $status = 1 ] || fail "a homing that was stopped: exit status $status: $(cat slow)"
grep -q 'not homed: stopped' slow || fail "a homing that was stopped: $(cat slow)"
"$jounce" order slide home --search-velocity 2mm/s > slow 2>&1 &
slow=$!
wait_for slide '"state":"homing"'
kill -INT $slow
status=0
wait $slow || status=$?
[ $status = 1 ] || fail "Ctrl-C: exit status $status: $(cat slow)"
grep -q 'not homed: stopped' slow || fail "Ctrl-C: $(cat slow)"

# and its end
order slide home || fail "home: $(cat out)"
grep -qx 'slide: homed' out || fail "home: $(cat out)"
wait_for slide '"homed":true'
order slide move --to 0mm || fail "move: $(cat out)"
wait_for slide standstill
order slide jog 5mm/s || fail "jog: $(cat out)"
refused 1 "keeps a constant velocity" slide home
order slide halt || fail "halt: $(cat out)"
wait_for slide standstill
order slide move --to 0mm || fail "move back: $(cat out)"
wait_for slide standstill
cat > long.toml <<'END'
jounce = 1
kind = "move"
units = { position = "mm" }
[move]
profile = "s_curve"
to = 100
velocity = 20
acceleration = 500
jerk = 20000
END
"$jounce" stream long.toml --to slide > streamed 2>&1 &
streamer=$!
wait_for slide _motion
got=0
order slide home || got=$?
if kill -0 $streamer 2> /dev/null; then
  [ $got = 1 ] && grep -q busy out || fail "home while a table is streamed: $got, $(cat out)"
else  # the streamer has released the axis, and the motion goes on
  [ $got = 1 ] && grep -q in_motion out || fail "home while a table is played: $got, $(cat out)"
fi
wait $streamer || fail "the stream: $(cat streamed)"
order bare home --offset 7mm || fail "home where it stands: $(cat out)"

kill -INT $executor
wait $executor || fail "the run: $(cat said)"
head -1 run.slide.csv | grep -q ',homed$' || fail "no column homed: $(head -1 run.slide.csv)"
tail -1 run.slide.csv | grep -q ',1$' || fail "the log ends unhomed: $(tail -1 run.slide.csv)"
grep -c ',homing,' run.slide.csv | grep -qv '^0$' || fail "no homing in the log"
tail -1 run.bare.csv | cut -d, -f6 | grep -qx 7 || fail "the bare axis does not end at 7 mm: $(tail -1 run.bare.csv)"
"$jounce" replay run.lcmlog > out || fail "the replay: $(cat out)"
