#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# two_machines_in_namespace.sh JOUNCE EXAMPLE_DIR: streamer and executor with a network of their own each, joined by a
# cable, as in docs/executor/two-machines.md. The cable is pulled while the axis moves.
set -eu
. "$(dirname "$0")/namespace.sh"
needs_network "a second machine"
jounce=$1 example=$2
url='udpm://239.255.76.67:7667?ttl=1'
. "$(dirname "$0")/machines.sh"

"$jounce" new key -o "$scratch/line.key" > /dev/null
cp "$example/axis.toml" "$scratch"
patient "$scratch/axis.toml"
there "$jounce" run "$scratch/axis.toml" --url "$url" --key "$scratch/line.key" --enable --watchdog 30 --log "$scratch/run.csv" \
  --once --seconds 40 2> "$scratch/notices" &
executor=$!
# Without a ttl nothing leaves this machine, and without the key nothing is believed.
"$jounce" monitor feeder --url "$url" --key "$scratch/line.key" --seconds 10 --silence 9 --json | head -1 > "$scratch/status"
grep -q '"state":"standstill"' "$scratch/status" || fail "no status of the executor over the cable"
status=0
"$jounce" monitor feeder --silence 1 2> "$scratch/err" || status=$?
[ $status = 3 ] || fail "without a ttl its status reaches the other machine"
"$jounce" stream "$example/cam.toml" --to feeder --url "$url" --patience 2 > /dev/null 2>&1 && fail "it was streamed without the key"
"$jounce" stream "$example/cam.toml" --to feeder --url "$url" --key "$scratch/line.key" || fail "the stream did not complete"
ip link set here down
wait $executor || fail "the executor ended badly: $(cat "$scratch/notices")"
played "$example/cam.toml" "$scratch/run.csv" || fail "another motion was played than the one designed"
