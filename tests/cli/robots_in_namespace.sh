#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# robots_in_namespace.sh JOUNCE EXAMPLES: groups of joints as an operator uses them: a SCARA robot picks and places, a
# delta moves in a frame, a gantry plays a program of a CAM system; rejections; judged in the space of the joints.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/namespace.sh"
jounce=$1
examples=$2
cd "$scratch"
cp -r "$examples/scara" "$examples/delta" "$examples/gantry" .
sed -i 's/^cycle.*/&\nlongest_gap = "900 ms"\nsession_timeout = "3 s"/' scara/a?.toml scara/z.toml delta/h?.toml gantry/??.toml

await() {  # await GROUP TEXT: until a status of the group has the text
  for i in $(seq 100); do
    "$jounce" monitor "$1" --json --seconds 0.3 > seen || true
    ! grep -q -- "$2" seen || return 0
  done
  fail "$1 never had $2: $(tail -2 seen)"
}
reaches() {  # reaches GROUP X Y Z: until the group rests there
  for i in $(seq 100); do
    "$jounce" monitor "$1" --json --seconds 0.3 > seen || true
    ! python3 -c '
import json, sys
last = [s for s in map(json.loads, open("seen")) if "place" in s][-1]
there = all(abs(a - float(b)) < 1e-6 for a, b in zip(last["place"], sys.argv[1:]))
sys.exit(not (there and last["path_length"] is None and last["commands"] == 0))' "$2" "$3" "$4" || return 0
  done
  fail "$1 never rested at $2 $3 $4: $(tail -2 seen)"
}
run() {  # run FOLDER GROUP
  "$jounce" run "$1/machine.toml" --enable --log "$1.csv" --record "$1.lcmlog" --seconds 200 2> "$1.notices" &
  executor=$!
  for i in $(seq 50); do ! "$jounce" order "$2" enable > out 2>&1 || return 0; sleep 0.2; done
  fail "enable: $(cat out) $(cat "$1.notices")"
}
end() {  # end FOLDER
  kill -INT $executor
  wait $executor || [ $? = 1 ] || fail "the run: $(cat "$1.notices")"
  "$jounce" replay "$1.lcmlog" > out || fail "the replay: $(cat out)"
}

# A SCARA robot picks and places; then single commands by the names of its coordinates.
run scara robot
reaches robot 300 250 0
order robot start || fail "start: $(cat out)"
await robot '"path_length":[0-9]'
reaches robot 300 250 0
refused 1 'out of reach of the joints' robot move-linear x=540 y=200
grep -q 'along the path' out || fail "no place in: $(cat out)"
refused 1 'singular\|out of reach' robot move-linear x=-300 y=-250 --velocity 100
got=0
order robot move-linear u=5 || got=$?
[ $got = 2 ] && grep -q 'names u, but the axes of the group are x, y, z' out || fail "an unknown name: $got, $(cat out)"
refused 1 'alone moves this axis' a0 move --to 5
order robot move-linear z=60 --velocity 200 || fail "move-linear: $(cat out)"
order robot move-linear x=420 y=-100 --velocity 200 --blend look-ahead --deviation 5 || fail "blend: $(cat out)"
order robot move-linear z=0 --velocity 200 --blend look-ahead --deviation 5 || fail "blend: $(cat out)"
reaches robot 420 -100 0
end scara
python3 "$here/judge_robot.py" scara scara.robot.csv scara.a0.csv scara.a1.csv scara.z_joint.csv || fail "the judge of the SCARA"

# A delta in a constant frame.
run delta delta
order delta set-coordinate-transform x=20 y=-10 --rotation 30 || fail "frame: $(cat out)"
await delta '"framed":true'
order delta move-linear x=0 y=0 z=40 --velocity 300 || fail "move-linear: $(cat out)"
for corner in "x=60 y=0" "x=60 y=40 z=10" "x=-40 y=40"; do
  order delta move-linear $corner --velocity 300 --blend look-ahead --deviation 3 || fail "$corner: $(cat out)"
done
reaches delta -40 40 10
refused 1 'out of reach\|h[123].position\|position_max' delta move-linear x=0 y=0 z=300
end delta
python3 "$here/judge_robot.py" delta delta.delta.csv delta.h1.csv delta.h2.csv delta.h3.csv || fail "the judge of the delta"

# A gantry whose beam has two motors plays its program, then one that is streamed.
run gantry gantry
order gantry start || fail "start: $(cat out)"
await gantry '"path_length":[0-9]'
order gantry override 50% || fail "override: $(cat out)"
await gantry '"estimated":true'
order gantry override 100% || fail "override: $(cat out)"
reaches gantry 0 0 0
printf 'G21 G90 G64 P0.1\nG1 X30 Y0 F6000\nG1 X30 Y30\nG1 X0 Y0\nM30\n' > short.ngc
sed '/^\[gcode/,/^file/d' gantry/part.toml > bed.toml
"$jounce" stream short.ngc --machine bed.toml --to gantry > out 2>&1 || fail "stream: $(cat out)"
await gantry '"path_length":[0-9]'
reaches gantry 0 0 0
end gantry
python3 "$here/judge_robot.py" stops gantry gantry.gantry.csv gantry.x1.csv gantry.y1.csv gantry.y2.csv gantry.z1.csv ||
  fail "the judge of the gantry"
