#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# kill_in_namespace.sh JOUNCE EXAMPLE_DIR: the streamer is killed half-way through a long table.
set -eu
. "$(dirname "$0")/namespace.sh"
sed 's/^rule = .*/rule = "linear"\nintervals = 400000/' "$2/cam.toml" > "$scratch/long.toml"
"$1" design "$scratch/long.toml" -o "$scratch/long.csv" 2> /dev/null > /dev/null || test $? = 1  # 1: its limits are broken
"$1" stream "$scratch/long.toml" --to nobody --patience 8 2> "$scratch/err" && fail "there was no answer, yet it succeeded"
grep -q "no answer from" "$scratch/err" || fail "the error is not no_answer: $(cat "$scratch/err")"

cp "$2/axis.toml" "$scratch"
patient "$scratch/axis.toml"
sed -i '/^session_timeout/d' "$scratch/axis.toml"  # 1 s: it is waited for
"$1" run "$scratch/axis.toml" --enable --watchdog 30 --log "$scratch/run.csv" --once --seconds 60 &
executor=$!
wait_for feeder standstill
"$1" stream "$scratch/long.toml" --to feeder --inject-loss 0.9 --patience 20 > /dev/null 2>&1 &
streamer=$!
sleep 1.5
kill -9 $streamer || fail "the streamer was already done: the test needs a slower one"
wait $streamer 2> /dev/null || true
soon shows feeder . || fail "the executor sends no status"
grep -q '"state":"standstill"' "$scratch/status" || fail "the axis left standstill: $(cat "$scratch/status")"
"$1" monitor feeder --seconds 0.5 --json | grep -v '"state":"standstill"' && fail "the axis left standstill"

# The dead session times out.
soon "$1" stream "$2/cam.toml" --to feeder || { kill $executor; fail "the next stream did not complete"; }
wait $executor || fail "the executor ended badly"
played "$2/cam.toml" "$scratch/run.csv" || fail "another motion was played"
