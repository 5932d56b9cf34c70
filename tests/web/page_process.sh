#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# page_process.sh JOUNCE: the process of a live page beside an axis in motion is attacked, killed and stopped. The axis
# goes on, the page comes back under its address until its fifth end within a minute, Stop always has a connection, and
# the page ends with the executor.
set -eu
. "$(dirname "$0")/../cli/namespace.sh"
. "$(dirname "$0")/with_panel.sh"
jounce=$1
page() {  # its process
  found=$(grep -l "^PPid:[[:space:]]*$executor\$" /proc/[0-9]*/status 2> /dev/null | cut -d/ -f3)
  [ -n "$found" ] && echo "$found"
}
moves() {
  for _ in $(seq 20); do  # a monitor of 0.5 s may get no status on a loaded machine
    "$jounce" monitor feeder --seconds 0.5 --json > "$scratch/seen" 2> /dev/null || true
    ! tail -1 "$scratch/seen" | grep -q '"state":"continuous_motion"' || return 0
  done
  fail "$1: $(tail -1 "$scratch/seen")"
}

python3 "$(dirname "$0")/attack_page.py" "$address" $executor || fail "see above"
"$jounce" order feeder jog 0.5mm/s > /dev/null || fail "the axis does not move"
# A status in the name of the axis whose text is not UTF-8: it killed the executor where the page was a part of it.
case $JOUNCE_BUS in
udpm:*)
  python3 "$(dirname "$0")/../cli/attack.py" TEXT 127.0.0.1 127.0.0.1 1 feeder
  moves "a text that is not UTF-8 had an effect"
  ;;
esac
first=$(page)
kill -9 "$first"
moves "the page was killed, and the axis does not move"
for _ in $(seq 600); do
  second=$(page) && [ "$second" != "$first" ] && break
  sleep 0.1
done
[ -n "$second" ] && [ "$second" != "$first" ] || fail "the page was not started again: $(cat "$scratch/said")"
python3 "$(dirname "$0")/attack_page.py" "$address" $executor stop || fail "the new page does not stop the axis"
kill -STOP "$second"
"$jounce" order feeder jog -0.5mm/s > /dev/null || fail "the axis obeys no order while its page is stopped"
moves "the page was stopped, and the axis does not move"
kill -INT $executor
wait $executor || fail "the executor ended badly: $(cat "$scratch/said")"
kill -0 "$second" 2> /dev/null && fail "the page has outlived its executor"

# The fifth end within a minute is the last one: the executor prints that, and the axis goes on.
"$jounce" run "$scratch/axis.toml" --enable --web 0 --seconds 500 2> "$scratch/said" &
executor=$!
for _ in $(seq 600); do
  page > /dev/null && break
  sleep 0.1
done
"$jounce" order feeder jog 0.5mm/s > /dev/null || fail "the axis does not move"
for ended in 1 2 3 4 5; do
  now=
  for _ in $(seq 600); do
    now=$(page) && break
    sleep 0.1
  done
  [ -n "$now" ] || fail "the page was not started again after $((ended - 1)) ends: $(cat "$scratch/said")"
  kill -9 "$now"
  for _ in $(seq 600); do
    [ "$(page)" = "$now" ] || break
    sleep 0.1
  done
done
for _ in $(seq 600); do
  grep -q 'has ended 5 times within a minute and is not started again' "$scratch/said" && break
  sleep 0.1
done
[ "$(grep -c 'ended and is started again' "$scratch/said")" = 4 ] || fail "not 4 starts again: $(cat "$scratch/said")"
grep -q 'has ended 5 times within a minute and is not started again' "$scratch/said" || fail "the limit is not reported: $(cat "$scratch/said")"
sleep 2
page && fail "the page was started again after its fifth end"
moves "the page is gone, and the axis does not move"
kill -INT $executor
wait $executor || fail "the executor ended badly without its page: $(cat "$scratch/said")"

# Killed, an executor does not leave its page behind either.
"$jounce" run "$scratch/axis.toml" --enable --web 0 --seconds 500 2> "$scratch/said" &
executor=$!
for _ in $(seq 600); do
  third=$(page) && break
  sleep 0.1
done
kill -9 $executor
for _ in $(seq 600); do
  kill -0 "$third" 2> /dev/null || exit 0
  sleep 0.1
done
fail "the page has outlived its executor, which was killed"
