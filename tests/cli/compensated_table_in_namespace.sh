#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# compensated_table_in_namespace.sh JOUNCE EXAMPLE: the table with two compensations as an operator uses it, then its logs
# judged and its record replayed. Wrong commands in between are rejected, and move nothing.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/namespace.sh"
jounce=$1
example=$2
cd "$scratch"
"$jounce" run "$example/machine.toml" --log run.csv --record run.lcmlog --seconds 100 2> said &
executor=$!
order() { "$jounce" order "$@" || fail "order $*"; }
# rejected REASON ARGUMENTS
rejected() {
  reason=$1
  shift
  if "$jounce" order "$@" > answer 2>&1; then fail "accepted: order $*"; fi
  grep -q -- "$reason" answer || { cat answer; fail "order $*: not for $reason"; }
}
# until_seen AXIS PATTERN: waits until a status of the axis has it.
until_seen() {
  for attempt in $(seq 40); do
    "$jounce" monitor "$1" --seconds 0.3 --json > seen 2> /dev/null || true
    tail -n 1 seen | grep -q -- "$2" && return
  done
  cat seen
  fail "the axis $1 is never $2"
}
until_seen y '"state":"disabled"'
rejected not_homed x enable-compensation
rejected compensation_inactive x disable-compensation
for axis in x y; do
  order $axis enable
  until_seen $axis '"state":"standstill"'
  rejected "enabled" $axis enable-compensation
  order $axis home
  order $axis move --to 120mm
  until_seen $axis '"position":120.0,'
  order $axis disable
  order $axis enable-compensation
  rejected compensation_active $axis enable-compensation
  rejected compensation_active $axis set-position 1
  order $axis enable
  until_seen $axis '"state":"standstill"'
  rejected compensation_active $axis home
done
rejected compensation_active x set-position 0 # y refers to x
order x move --to 800mm
rejected in_motion x disable-compensation
order y move --to -130mm --velocity 100mm/s
rejected position_limit y move --to 5000mm
until_seen x '"position":800.0,'
until_seen y '"position":-130.0,'
order x move --to 450mm
until_seen x '"position":450.0,'
"$jounce" monitor x --seconds 0.3 > shown 2> /dev/null || true
grep -q "compensated 0.254883 mm" shown || { cat shown; fail "the monitor shows no correction"; }
order y disable
order y disable-compensation
rejected compensation_inactive y disable-compensation
order y enable
until_seen y '"state":"standstill"'
order y move --to 0mm
until_seen y '"position":0.0,'
kill -INT $executor
wait $executor || fail "the executor ended badly: $(cat said)"
python3 "$here/judge_compensation.py" run.x.csv run.y.csv || fail "the judge of the logs"
"$jounce" replay run.lcmlog > replayed || { cat replayed; fail "the replay differs"; }
