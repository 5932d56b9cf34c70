#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# printing_line_in_namespace.sh JOUNCE EXAMPLE: the printing line of the examples as an operator uses it, then its logs
# judged and its record replayed. Wrong commands in between are rejected, and change nothing.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/namespace.sh"
jounce=$1
example=$2
cd "$scratch"
cp "$example"/*.toml .
patient line.toml corrector.toml label.toml
"$jounce" run machine.toml --enable --watchdog 30 --log run.csv --record run.lcmlog --seconds 60 2> said &
executor=$!
order() { "$jounce" order "$@" || fail "order $*"; }
# rejected REASON ARGUMENTS
rejected() {
  reason=$1
  shift
  if "$jounce" order "$@" > answer 2>&1; then fail "accepted: order $*"; fi
  grep -q -- "$reason" answer || { cat answer; fail "order $*: not for $reason"; }
}
wait_for label standstill
rejected not_synchronized label phasing --by 2
rejected no_movement line change-velocity 50mm/s
rejected no_movement line finish
rejected "no live master" line gear-in 1:1
rejected "no live master" corrector combine 1:1 --second 1:1
rejected "must be greater than 0" line change-velocity 0mm/s
rejected "must be 0 or more" corrector repeat --to 1 --wait -1s
rejected "must be a ratio" label combine 1:1 --second half
rejected "second: is missing" label combine 1:1
order line jog 40mm/s
order label gear-in 1:1 --clutch 200mm
rejected in_motion label gear-in 2:1 --clutch 100mm # the clutch has not ended
rejected "cannot be combined" label gear-in 2:1 --clutch 100mm --acceleration 5
order line change-velocity 300mm/s
soon past label 200 || fail "the label does not follow: $(cat "$scratch/status")" # 100 mm in the clutch
rejected velocity_limit label phasing --by 5mm --velocity 5000mm/s
rejected no_such_move label phasing --by 1e300
rejected acceleration_limit label gear-in 3:1 --clutch 0.01mm
order label phasing --by 2.5mm
sleep 0.5
order label phasing --to 0mm --velocity 5mm/s
sleep 1.5
order label gear-in 4:5 --clutch 100mm
rejected "by a gear: end the gear with .jounce order label halt" label change-velocity 100mm/s
sleep 1
order label combine 1:1 --second -1:2
sleep 0.5 # the label is in step before its second master begins, whose jerk adds to that of the label
order corrector repeat --to 4mm --wait 100ms
rejected in_motion corrector repeat --to 5mm
past=$(position line | awk '{ print int($1) + 900 }')
order line change-velocity 100mm/s --past "$past"mm
wait_for line '"velocity":100\.0'
sleep 1.5 # the last second of the judge
"$jounce" stop label
order corrector finish
sleep 1
order line halt
sleep 1
kill -INT $executor
wait $executor || fail "the executor ended badly: $(cat said)"
python3 "$here/judge_couplings.py" run.line.csv run.corrector.csv run.label.csv || fail "the judge of the logs"
"$jounce" replay run.lcmlog > replayed || { cat replayed; fail "the replay differs"; }
