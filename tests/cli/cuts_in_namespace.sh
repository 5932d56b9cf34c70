#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# cuts_in_namespace.sh JOUNCE EXAMPLE_DIR: a shear and a knife cut a web while its line accelerates. Lengths change,
# cuts come on demand, both return home. A judge compares the logs with the cuts. Wrong commands get their numbers.
set -eu
. "$(dirname "$0")/namespace.sh"
here=$root/tests/cli
cp -r "$2" "$scratch/example"
sed -i 's/cycle = "1 ms"/cycle = "1 ms"\nlongest_gap = "1 s"/' "$scratch/example/carriage.toml" "$scratch/example/drum.toml"
sed -i 's/to = 16000/to = 10000/' "$scratch/example/line.toml"
cd "$scratch"
"$1" run example/machine.toml --enable --log run.csv --record run.lcmlog --seconds 21 2> said &
executor=$!
refused() {  # refused TEXT COMMAND...: the axis rejects the command with this text
  text=$1
  shift
  "$@" > answer 2>&1 && fail "accepted: $*"
  tr '\n' ' ' < answer | grep -q -e "$text" || fail "$*: $(cat answer)"
}
for i in 1 2 3 4 5 6 7 8 9 10; do "$1" monitor shear --seconds 0.1 > /dev/null 2>&1 && break; sleep 0.3; done
refused 'no_cut_plan.*start' "$1" order shear cut --length 1.3m
"$1" order shear start || fail "the shear did not start"
"$1" order knife start || fail "the knife did not start"
refused 'web_stands.*--position' "$1" order shear cut
refused 'cut_length.*: 500 mm, nearest possible length' "$1" order shear cut --length 500mm
refused 'cut_position.*cut at -20 mm, next possible cut at' "$1" order shear cut --position=-20mm
refused 'at most one' "$1" order shear cut --length 1.3m --waste 1.2m
"$1" order shear cut --length 1.3m || fail "no new length"
"$1" order line start || fail "the line did not start"
"$1" order shear cut --length 1.4m || fail "no new length while the line accelerates"
"$1" order knife cut --length 400mm || fail "no new length of the knife"
demand=5600
until "$1" order shear cut --position ${demand}mm > answer 2>&1; do
  demand=$(sed -n 's/.*next possible cut at \([0-9.]*\) mm.*/\1/p' answer)
  [ -n "$demand" ] || fail "no next possible cut: $(cat answer)"
  demand=$(echo "$demand" | sed 's/\..*//')
  demand=$((demand + 1))
done
refused 'cut_too_far.*last possible cut at' "$1" order shear cut --position 1e9mm
position() { "$1" monitor line --seconds 0.1 --json | tail -1 | sed 's/.*"position":\([-0-9]*\).*/\1/'; }
for i in $(seq 300); do  # until the cut on demand is made
  [ "$(position "$1")" -gt "$demand" ] && break
done
"$1" order shear cut || fail "no cut as soon as possible"
for i in $(seq 100); do
  [ "$(position "$1")" -gt $((demand + 1400)) ] && break
done
"$1" order shear park || fail "the shear does not park"
"$1" order knife park || fail "the knife does not park"
wait $executor || { cat said; fail "the run ended badly"; }
"$1" check example/shear.toml > report || fail "the example breaks a limit"
soonest=$(sed -n 's/^ *next cut *\([0-9.]*\) mm.*/\1/p' report)
/usr/bin/python3 "$here/judge_cuts.py" run.shear.csv --slope 1 --turn 0 --sync 150 --velocity 2000 --acceleration 10000 \
  --home 0 --first 600 --lengths 1300,1400 --demand "$demand" --soonest "$soonest" || fail "the shear"
/usr/bin/python3 "$here/judge_cuts.py" run.knife.csv --slope 1.1999116128394203 --turn 360 --sync 16.6 --velocity 6000 \
  --acceleration 171887.4 --home 180 --first 311.9277372439294 --lengths 250,800,120,400 || fail "the knife"
"$1" replay run.lcmlog || fail "the replay differs"
