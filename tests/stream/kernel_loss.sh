#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# kernel_loss.sh PROGRAM: the fault matrix between two real links (docs/stream-faults.md). The kernel itself loses and
# doubles the packets (iptables, `statistic` and `TEE`); relay.py doubles, corrupts and reorders them between two links.
# Exit 77 after one line where there is no network namespace or no iptables.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
[ "${JOUNCE_INSIDE:-}" = 1 ] || JOUNCE_INSIDE=1 exec timeout 170 "$root/scripts/own_network" "$0" "$@"
program=$1
case $JOUNCE_BUS in unix:*) echo "skipped: loss in the kernel needs a network namespace"; exit 77 ;; esac
add() { iptables -A INPUT -i lo -p udp --dport 7667 "$@" -j DROP 2> "$scratch/why"; }
clear() { iptables -F INPUT; }
scratch=$(mktemp -d)
relay=
trap 'test -z "$relay" || kill "$relay"; rm -rf "$scratch"' EXIT
add -m statistic --mode random --probability 0.5 || { echo "skipped: no iptables with statistic here: $(head -1 "$scratch/why")"; exit 77; }
clear
# once LABEL KNOTS [ends]: a stream; whole and started, or with `ends`: that, or a named error and nothing wrong stored.
once() { "$program" once "$JOUNCE_BUS" "$@"; }

for share in 0.01 0.1 0.3; do
  add -m statistic --mode random --probability $share
  for knots in 10 1000 100000; do once "random $share" $knots; done
  clear
done
add -m statistic --mode nth --every 3 --packet 0
once "every third" 100000
clear

# Doubled by the kernel: TEE sends the copy over lo once more, and so it may be doubled again.
double() {
  iptables -t mangle "$1" PREROUTING -i lo -p udp --dport 7667 \
    -m statistic --mode random --probability 0.3 -j TEE --gateway 127.0.0.1
}
if double -A 2> "$scratch/why"; then
  for knots in 10 1000 100000; do once "doubled 0.3" $knots; done
  add -m statistic --mode random --probability 0.1
  once "doubled 0.3, random 0.1" 100000
  clear
  # rule, packets, bytes, ...
  doubled=$(iptables -t mangle -L PREROUTING -v -n -x | awk '/TEE/ {print $1}')
  [ "$doubled" -gt 50 ] || { echo "FAILED: the kernel has doubled $doubled packets"; exit 1; }
  echo "doubled by the kernel: $doubled packets"
  double -D
else
  echo "left out: no TEE in this kernel: $(head -1 "$scratch/why")"
fi

# Between the streamer's link (port 7667) and the executor's (7668) the relay is the only way.
relayed() {  # relayed LABEL KNOTS WHAT=SHARE...
  label=$1 knots=$2
  shift 2
  python3 "$root/tests/stream/relay.py" 7667 7668 60 7 "$@" > "$scratch/relay" &
  relay=$!
  for _ in $(seq 100); do grep -q ready "$scratch/relay" && break; sleep 0.1; done
  timeout 60 "$program" relayed "$JOUNCE_BUS" "${JOUNCE_BUS%:*}:7668" "$label" "$knots" || exit 1
  kill $relay
  wait $relay
  relay=
  for what in passed "$@"; do
    python3 -c 'import json, sys; sys.exit(json.loads(open(sys.argv[1]).readlines()[-1])[sys.argv[2]] == 0)' \
      "$scratch/relay" "${what%=*}" || { echo "FAILED: nothing was ${what%=*}: $(cat "$scratch/relay")"; exit 1; }
  done
  tail -1 "$scratch/relay"
}
relayed "doubled" 100000 doubled=0.3
relayed "reordered" 100000 delayed=0.5
relayed "corrupted" 100000 corrupted=0.05
for knots in 100000 300000; do
  relayed "all of it" $knots lost=0.1 doubled=0.1 corrupted=0.05 delayed=0.3
done

# While a table is sent: cut for a while, both ways; one way by what the channel is called, where the kernel has `string`.
cut() {  # cut LABEL SECONDS ENDS MATCH...
  label=$1 seconds=$2 ends=$3
  shift 3
  once "$label" 1000000 $ends &
  stream=$!
  sleep 0.1
  add "$@" || { echo "left out: $label: no such match in this kernel"; wait $stream; return; }
  sleep "$seconds"
  clear
  wait $stream
}
cut "cut for 0.5 s" 0.5 "" -m udp
cut "cut for 3 s" 3 ends -m udp
cut "replies cut for 0.5 s" 0.5 "" -m string --algo bm --string .reply
cut "all but replies cut for 0.5 s" 0.5 "" -m string --algo bm ! --string .reply
cut "replies cut for 3 s" 3 ends -m string --algo bm --string .reply
add -m udp
once "cut for good" 1000 ends
