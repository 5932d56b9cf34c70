#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# play_in_namespace.sh JOUNCE EXAMPLE_DIR SHARE_OF_PACKETS_LOST
set -eu
. "$(dirname "$0")/namespace.sh"
"$1" run "$2/axis.toml" --enable --log "$scratch/run.csv" --once --seconds 40 --inject-loss "$3" --seed 7 &
executor=$!
"$1" stream "$2/cam.toml" --to feeder --inject-loss "$3" --seed 11 || { kill $executor; fail "the stream did not complete"; }
"$1" monitor feeder --seconds 0.5 --json | grep -q '"state":"synchronized_motion"' || fail "the monitor does not see it running"
wait $executor || fail "the executor ended badly"
"$1" validate "$2/cam.toml" --log "$scratch/run.csv" || fail "another motion was played than the one designed"
