#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# kill_in_namespace.sh JOUNCE EXAMPLE_DIR: the streamer is killed half-way through a long table.
set -eu
. "$(dirname "$0")/namespace.sh"
sed 's/^rule = .*/rule = "linear"\nintervals = 400000/' "$2/cam.toml" > "$scratch/long.toml"
"$1" design "$scratch/long.toml" -o "$scratch/long.csv" 2> /dev/null > /dev/null
"$1" stream "$scratch/long.toml" --to nobody --patience 8 2> "$scratch/err" && fail "there was no answer, yet it succeeded"
grep -q no_answer "$scratch/err" || fail "the error is not no_answer: $(cat "$scratch/err")"

"$1" run "$2/axis.toml" --enable --log "$scratch/run.csv" --once --seconds 40 &
executor=$!
sleep 0.5
"$1" stream "$scratch/long.toml" --to feeder --inject-loss 0.9 --patience 20 > /dev/null 2>&1 &
streamer=$!
sleep 1.5
kill -9 $streamer || fail "the streamer was already done: the test needs a slower one"
wait $streamer 2> /dev/null || true
"$1" monitor feeder --seconds 0.5 --json > "$scratch/status"
grep -q '"state":"standstill"' "$scratch/status" || fail "the axis is not at standstill: $(head -1 "$scratch/status")"
grep -v '"state":"standstill"' "$scratch/status" && fail "the axis left standstill"

sleep 1  # the dead session times out
"$1" stream "$2/cam.toml" --to feeder || { kill $executor; fail "the next stream did not complete"; }
wait $executor || fail "the executor ended badly"
"$1" validate "$2/cam.toml" --log "$scratch/run.csv" || fail "another motion was played"
