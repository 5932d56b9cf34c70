#!/bin/sh
# kernel_loss.sh PROGRAM: the fault matrix where the kernel itself loses the packets (iptables, `statistic`), between two
# real links: docs/stream-faults.md. Exit 77 after one line where there is no network namespace or no iptables.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
[ "${JOUNCE_INSIDE:-}" = 1 ] || JOUNCE_INSIDE=1 exec timeout 170 "$root/scripts/own_network" "$0" "$@"
program=$1
case $JOUNCE_BUS in unix:*) echo "skipped: loss in the kernel needs a network namespace"; exit 77 ;; esac
add() { iptables -A INPUT -i lo -p udp --dport 7667 "$@" -j DROP 2> "$scratch/why"; }
clear() { iptables -F INPUT; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
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
