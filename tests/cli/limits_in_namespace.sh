#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# limits_in_namespace.sh JOUNCE EXAMPLES: the limits, the override, the coordinates and the M words of a group as an
# operator sets them, rightly and wrongly; jogs of a SCARA to the ends of its reach; converted positions. The logs are judged.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/namespace.sh"
jounce=$1
examples=$2
cd "$scratch"
cp -r "$examples/plotter" "$examples/scara" .
patient plotter/?.toml scara/a?.toml scara/z.toml

run() {  # run FOLDER GROUP
  "$jounce" run "$1/machine.toml" --enable --watchdog 30 --log "$1.csv" --record "$1.lcmlog" --seconds 100 2> said &
  executor=$!
  soon "$jounce" order "$2" enable || fail "no executor: $(cat said)"
}
end() {  # end FOLDER
  kill -INT $executor
  wait $executor || [ $? = 1 ] || fail "the run: $(cat said)"
  "$jounce" replay "$1.lcmlog" > out || fail "the replay: $(cat out)"
}
tick() {
  wait_for "$1" '"tick":'
  sed 's/.*"tick":\([0-9]*\).*/\1/' "$scratch/status"
}
# there GROUP AXIS POSITION: the axis is at the position, and the group rests.
there() {
  position "$2" > now
  awk -v at="$(cat now)" -v to="$3" 'BEGIN { exit !(at - to < 1e-6 && to - at < 1e-6) }' &&
    shows "$1" '"state":"standstill".*"queue_rows":0'
}
reaches() { soon there "$@" || fail "$1: $2 is at $(cat now), not at $3"; }

# ---- converted positions: no executor runs
convert() { "$jounce" position scara/machine.toml "$@" > out 2>&1; }
convert x=300 y=250 z=0 || fail "position: $(cat out)"
python3 - << 'END' || fail "the joints of (300, 250): $(cat out)"
at = {name: float(rest.split()[0]) for name, rest in (line.split(" = ") for line in open("out"))}
raise SystemExit(not (abs(at["a0"]) < 1e-9 and abs(at["a1"] - 90) < 1e-9 and at["z_joint"] == 0))
END
convert a0=0deg a1=90 z_joint=1cm || fail "position: $(cat out)"
grep -q '^z = 10 mm' out || fail "the tool: $(cat out)"
wrong() {  # wrong STATUS WORDS VALUES...
  status=$1
  words=$2
  shift 2
  got=0
  convert "$@" || got=$?
  [ $got = "$status" ] && grep -q -- "$words" out || fail "position $*: $got, $(cat out)"
}
wrong 1 'a1 = .* deg (below position_min, 5 deg)' x=549.9 y=0 z=0
wrong 2 'is out of reach of the joints' x=600 y=0 z=0
wrong 2 'is missing' x=300 y=250
wrong 2 'is given twice' x=300 x=250 z=0
wrong 2 'is not one of x, y, z, and not one of a0, a1, z_joint' u=1
wrong 2 'must be a position with its name' 300
wrong 2 'mm' x=3s y=0 z=0
got=0
"$jounce" position plotter/machine.toml x=1 y=2 > out 2>&1 || got=$?
[ $got = 2 ] && grep -q 'kinematics: is missing' out || fail "a group without kinematics: $got, $(cat out)"

# ---- a plotter
run plotter plotter
refused 2 'must be more than 0% and at most 100%' plotter set-override --acceleration-factor 0%
refused 2 'must be more than 0% and at most 100%' plotter set-override --jerk-factor 150%
refused 2 'must be from 0% to 200%' plotter set-override --velocity-factor 300%
refused 2 'must be greater than 0' plotter set-limits --velocity -5
refused 2 'does not apply to set-limits' plotter set-limits --radius 5
refused 1 '--axis = 3: must be 1 (x) or 2 (y)' plotter set-limits --axis 3 --velocity 5
refused 1 'applies along the path only' plotter set-limits --axis 1 --deceleration 5
refused 1 not_a_group x set-limits --velocity 5
refused 1 not_a_group x set-override --velocity-factor 50%
refused 1 single_axis plotter set-position 5
refused 2 'names z, but the axes of the group are x, y' plotter set-position z=5
refused 1 'the group has 2 axes' plotter set-position --to 1,2,3

marks=$(tick plotter)
order plotter set-override --acceleration-factor 25% --jerk-factor 20% || fail "set-override: $(cat out)"
order plotter move-linear x=100mm --velocity 100mm/s || fail "move-linear: $(cat out)"
reaches plotter x 100
marks="$marks $(tick plotter)"
order plotter set-override || fail "set-override: $(cat out)"
order plotter set-limits --axis 1 --velocity 20mm/s || fail "set-limits: $(cat out)"
order plotter move-linear x=80 y=40 --velocity 100 || fail "move-linear: $(cat out)"
reaches plotter x 80
marks="$marks $(tick plotter)"
order plotter set-limits --axis 1 || fail "no limits: $(cat out)"
order plotter move-linear x=200 --velocity 20 --acceleration 100 --jerk 1000 || fail "move-linear: $(cat out)"
order plotter set-limits --velocity 10 || fail "set-limits: $(cat out)"
soon shows plotter '"override":0\.[1-6]' || fail "the motion keeps its speed: $(cat "$scratch/status")"
order plotter set-limits || fail "no limits: $(cat out)"
order plotter override 200% || fail "override: $(cat out)"
soon shows plotter '"override":2' || fail "the reserve is not used: $(cat "$scratch/status")"
reaches plotter x 200
order plotter override 100% || fail "override: $(cat out)"
marks="$marks $(tick plotter)"
order plotter set-position x=0 y=0 || fail "set-position: $(cat out)"
order plotter move-linear x=-200 y=-40 --velocity 150 || fail "move-linear: $(cat out)"
reaches plotter x 0
marks="$marks $(tick plotter)"

refused 1 no_handshake plotter acknowledge
refused 2 'must be a whole number' plotter m-word six
refused 1 'must be at least 1' plotter m-word 0
order plotter m-word 6 --timeout 90 || fail "m-word: $(cat out)"
order plotter move-linear --by 5,0 --velocity 50 --buffered || fail "move-linear: $(cat out)"
wait_for plotter '"state":"standstill".*"reason":"awaits_acknowledge"'
grep -q 'M6 waits for' said || fail "no notice of M6: $(cat said)"
refused 1 "for an acknowledgment of M6, not of M5" plotter acknowledge --m-word 5
order plotter acknowledge --m-word 6 || fail "acknowledge: $(cat out)"
reaches plotter x 5
order plotter m-word 8 || fail "m-word: $(cat out)"
order plotter move-linear --by 5,0 --velocity 50 --buffered || fail "move-linear: $(cat out)"
wait_for plotter '"state":"standstill".*"reason":"awaits_acknowledge"'
order plotter move-linear --by -1,0 --velocity 50 || fail "move-linear: $(cat out)"
reaches plotter x 4
grep -q 'an aborting command replaces the waiting commands: 2 commands were dropped' said || fail "no notice: $(cat said)"
order plotter m-word 9 || fail "m-word: $(cat out)"
order plotter move-linear --by 5,0 --velocity 50 --buffered || fail "move-linear: $(cat out)"
wait_for plotter '"state":"standstill".*"reason":"awaits_acknowledge"'
order plotter halt || fail "halt: $(cat out)"
noticed() { grep -q "$1" said; }
soon noticed 'the waiting commands do not begin: 2 commands were dropped' || fail "no notice of the halt: $(cat said)"
order plotter m-word 7 --timeout 6s || fail "m-word: $(cat out)"
order plotter move-linear --by 5,0 --velocity 50 --buffered || fail "move-linear: $(cat out)"
wait_for plotter '"state":"standstill".*"reason":"no_acknowledge"'
grep -q 'M7 was not acknowledged within 6 s: 1 command that follows it was dropped' said || fail "no notice: $(cat said)"
end plotter
python3 "$here/judge_limits.py" plotter.plotter.csv plotter.x.csv plotter.y.csv $marks || fail "the judge of the plotter"

# ---- jogs of a SCARA
run scara robot
order robot jog --along x=1 --velocity 200 || fail "jog: $(cat out)"
wait_for robot '"state":"standstill".*"reason":"range_end"'
grep -q 'the jog ends at x = 489.3[0-9]* mm, y = 250 mm, z = 0 mm: there, a1 reaches the end of its position range, 5 deg' said ||
  fail "no notice of the end: $(cat said)"
refused 1 'leads outward' robot jog --along x=1
order robot jog --along y=-1 --velocity 200 || fail "jog: $(cat out)"
wait_for robot '"state":"standstill".*"reason":"range_end"'
order robot jog --along x=-1 --velocity 300 || fail "jog: $(cat out)"
wait_for robot '"state":"discrete_motion".*"reason":"none"'
wait_for robot '"state":"standstill".*"reason":"range_end"'
end scara
python3 "$here/judge_robot.py" jogs scara.robot.csv scara.a0.csv scara.a1.csv scara.z_joint.csv || fail "the judge of the jogs"

# ---- queued limits of a joint; an order that is accepted with a remark ends with the exit status 0
cp -r "$examples/scara" queued
patient queued/a?.toml queued/z.toml
run queued robot
order robot wait 3 || fail "wait: $(cat out)"
order robot move-linear x=350 y=150 --velocity 5000 || fail "an order with a remark: $(cat out)"
grep -q 'move-linear accepted; the limits lower the velocity from 5000 mm/s' out || fail "no remark: $(cat out)"
order robot set-limits --axis 1 --velocity 12 --acceleration 100 --jerk 1500 --queued || fail "set-limits: $(cat out)"
order robot move-linear x=420 y=0 --velocity 200 --blend look-ahead --deviation 3 || fail "move-linear: $(cat out)"
order robot set-limits --axis 1 --queued || fail "no limits: $(cat out)"
order robot move-linear x=300 y=-200 --velocity 200 --blend look-ahead --deviation 3 || fail "move-linear: $(cat out)"
wait_for robot '"queue_rows":[1-9]'
wait_for robot '"state":"standstill".*"queue_rows":0'
end queued
python3 "$here/judge_joint_limits.py" queued.robot.csv queued.a0.csv queued.a1.csv queued.z_joint.csv ||
  fail "the judge of the limits of a joint"
