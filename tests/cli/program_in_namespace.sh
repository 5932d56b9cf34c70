#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# program_in_namespace.sh JOUNCE EXAMPLE: a G-code program that is sent as a whole to the plotter of the examples. Its M words
# wait, or pass; its H words switch outputs on the path; single step stops at each command. The log is judged and replayed.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/namespace.sh"
jounce=$1
example=$2
cd "$scratch"
cp "$example"/*.toml .
patient x.toml y.toml
sed -i 's/^tolerance = "1 um".*/&\nm_words = [0, 6]\nm_word_timeout = "60 s"/' machine.toml
sed '/^\[\[command/,$d' square.toml > bed.toml
cat > part.ngc << 'END'
G21 G90 G64 P0.1
T1 M6
G1 X20 Y0 F1800 H1
X40 H-1 M8
X40 Y20 H2
G2 X40 Y40 J10 G61
M0
G64 P0.1
G1 X20 Y40 H-2
X0 Y40
X0 Y0
M30
END
sed "s/F1800 H1/F1800 H33/" part.ngc > wrong.ngc

got=0
sed 's/m_words = \[0, 6\]/m_words = [0.5]/' machine.toml > odd.toml
"$jounce" run odd.toml --seconds 1 > out 2>&1 || got=$?
[ $got = 2 ] && grep -q 'must be "all", or a list of M words' out || fail "an odd M word: $got, $(cat out)"

"$jounce" run machine.toml --enable --watchdog 30 --log run.csv --record run.lcmlog --seconds 110 2> said &
executor=$!
soon "$jounce" order plotter enable || fail "no executor: $(cat said)"
stream() { "$jounce" stream "$1" --machine bed.toml --to plotter > out 2>&1; }
waits() { wait_for plotter '"state":"standstill".*"reason":"awaits_acknowledge"'; }
at() {  # at X Y: the axes are there
  for one in "x $1" "y $2"; do
    set -- $one
    position "$1" > now
    awk -v at="$(cat now)" -v to="$2" 'BEGIN { exit !(at - to < 1e-6 && to - at < 1e-6) }' || fail "$1 is at $(cat now), not $2"
  done
}

stream wrong.ngc && fail "an output 33: $(cat out)"
grep -q 'wrong.ngc:3.*H33.*above 32' out || fail "an output 33: $(cat out)"

"$jounce" monitor plotter --events --seconds 90 > events 2>&1 &
monitor=$!
stream part.ngc || fail "stream: $(cat out)"
waits
at 0 0
grep -q 'M6 waits for' said || fail "no notice of M6: $(cat said)"
got=0
stream part.ngc || got=$?
[ $got = 1 ] && grep -q 'awaits_acknowledge' out || fail "a second program: $got, $(cat out)"
refused 1 awaits_acknowledge plotter start
refused 1 "for an acknowledgment of M6, not of M8" plotter acknowledge --m-word 8
order plotter acknowledge --m-word 6 || fail "acknowledge: $(cat out)"
wait_for plotter '"state":"discrete_motion"'
refused 1 no_handshake plotter acknowledge
order plotter override 60% || fail "override: $(cat out)"
waits
at 40 40
order plotter single-step --on || fail "single-step: $(cat out)"
order plotter acknowledge || fail "acknowledge: $(cat out)"
for place in "20 40" "0 40"; do
  waits
  at $place
  order plotter acknowledge || fail "acknowledge: $(cat out)"
  wait_for plotter '"state":"standstill"'
done
wait_for plotter '"state":"standstill".*"reason":"none"'
at 0 0
order plotter single-step || fail "single-step: $(cat out)"
order plotter override 100% || fail "override: $(cat out)"

# Single step during the motion; then a stop at the wait drops the rest.
printf 'G21 G90 G64 P0.1\nG1 X30 F600\nY10\nX60\nY20\nX90\nY30\nX120\nM30\n' > stairs.ngc
stream stairs.ngc || fail "stream: $(cat out)"
soon past x 5 || fail "it does not move"
order plotter single-step --on || fail "single-step: $(cat out)"
waits
position x > now
grep -Eq '^(30|60|90)' now || fail "it stopped at $(cat now)"
"$jounce" stop plotter > out 2>&1 || fail "stop: $(cat out)"
refused 1 no_handshake plotter acknowledge
order plotter single-step || fail "single-step: $(cat out)"
order plotter disable || fail "disable: $(cat out)"
kill $monitor
wait $monitor || true
grep -q 'M6 waits' events && grep -q 'M8 passes' events && grep -q 'M0 waits' events || fail "the events: $(cat events)"
grep -q 'track 1 on' events || fail "the events: $(cat events)"

kill -INT $executor
wait $executor || [ $? = 1 ] || fail "the run: $(cat said)"
python3 "$here/judge_program.py" run.x.csv run.y.csv run.plotter.csv || fail "the judge of the log"
"$jounce" replay run.lcmlog > out || fail "the replay: $(cat out)"
