#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# play_in_namespace.sh JOUNCE EXAMPLE_DIR SHARE_OF_PACKETS_LOST
set -eu
. "$(dirname "$0")/namespace.sh"
cp "$2/axis.toml" "$scratch"
patient "$scratch/axis.toml"
"$1" run "$scratch/axis.toml" --enable --watchdog 30 --log "$scratch/run.csv" --once --seconds 40 --inject-loss "$3" --seed 7 &
executor=$!
"$1" stream "$2/cam.toml" --to feeder --inject-loss "$3" --seed 11 || { kill $executor; fail "the stream did not complete"; }
wait_for feeder '"state":"synchronized_motion"'
wait $executor || fail "the executor ended badly"
played "$2/cam.toml" "$scratch/run.csv" || fail "another motion was played than the one designed"
