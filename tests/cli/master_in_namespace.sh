#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# master_in_namespace.sh JOUNCE EXAMPLE_DIR FOLLOWS: the example over UDP, one in ten packets of the line lost; then
# the line falls silent under a follower.
set -eu
. "$(dirname "$0")/namespace.sh"
"$1" design "$2/cam.toml" -o "$scratch/cam.csv"
cp "$2"/*.toml "$scratch"
patient "$scratch/label.toml"
sed -i 's/^longest_age = .*/longest_age = "500 ms"/' "$scratch/machine.toml"
"$1" run "$scratch/machine.toml" --enable --watchdog 30 --record "$scratch/run.lcmlog" --seconds 40 2> "$scratch/said" &
executor=$!
wait_for label standstill
"$1" master "$2/line.toml" --as line --before 5 --after 2 --inject-loss 0.1 --seed 5 > "$scratch/line" &
line=$!
"$1" stream "$2/cam.toml" --to label --live --start-at 250 || { kill $executor $line; fail "the cam was not started"; }
"$1" monitor label --seconds 6 --json > "$scratch/seen"
grep -q '"master_name":"line".*"lost":false' "$scratch/seen" || fail "the monitor does not see the line"
grep -q '"state":"synchronized_motion"' "$scratch/seen" || fail "the label does not follow"
wait $line || fail "the sender ended badly"
soon grep -q 'master line is lost' "$scratch/said" || fail "no message that the line was lost"
soon grep -q master_lost "$scratch/said" || fail "the label did not stop for it"
kill -INT $executor
wait $executor && fail "a lost master is a fault, and the run ended with status 0"
"$1" replay "$scratch/run.lcmlog" || fail "the replay differs"
# Started from 0 in the dwell after 250 mm, one label later by the cam: 90 mm less.
"$3" "$scratch/run.lcmlog" "$scratch/cam.csv" label line -90 || fail "another motion than the cam of the line"
