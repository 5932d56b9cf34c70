#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# two_operators_in_namespace.sh JOUNCE EXAMPLES: two operators at one machine. Orders at the same time, stops of the
# motions of the other one, an override in a fault, commands for a later tick, and a knife that waits for its line.
set -eu
export OWN_NETWORK=no  # programs meet in a folder of Unix sockets
here=$(cd "$(dirname "$0")" && pwd)
. "$here/namespace.sh"
jounce=$1
examples=$2
cd "$scratch"
cp -r "$examples/plotter" "$examples/scara" .
patient plotter/?.toml scara/a?.toml scara/z.toml

run() {  # run MACHINE GROUP
  "$jounce" run "$1" --enable --watchdog 30 --seconds 100 2> said &
  executor=$!
  soon "$jounce" order "$2" enable || fail "no executor: $(cat said)"
}
end() {
  kill -INT $executor
  wait $executor || [ $? = 1 ] || fail "the run: $(cat said)"
}
# answers WORDS ARGUMENTS...: the order is accepted, and its answer has these words.
answers() {
  words=$1
  shift
  order "$@" || fail "$*: $(cat out)"
  grep -q -- "$words" out || fail "$*: not '$words': $(cat out)"
}
# jogs_until WORDS NAME OPTIONS...: a hold-to-run jog of NAME ends with status 1 and these words when another operator
# stops x. On a busy machine, its heartbeats may come too late, or the stop before the jog: then it is repeated.
jogs_until() {
  words=$1
  shift
  for _ in $(seq 20); do
    wait_for "$1" '"state":"standstill".*"queue_rows":0'
    name=$1
    (shift && exec "$jounce" order "$name" jog "$@" --hold-to-run --seconds 4) > jogged 2>&1 &
    jog=$!
    sleep 0.6
    "$jounce" stop x > out 2>&1 || fail "stop x: $(cat out)"
    got=0
    wait $jog || got=$?
    [ $got != 0 ] || continue
    ! grep -q 'no heartbeat' jogged || continue
    [ $got = 1 ] && grep -q "$words" jogged || fail "the end of a jog of $name: $got, $(cat jogged)"
    return
  done
  fail "no jog of $1 was stopped: $(cat jogged)"
}
# stopped PID FILE: the command in the background ended with status 1, and names the other operator.
stopped() {
  got=0
  wait "$1" || got=$?
  [ $got = 1 ] || fail "exit status $got, not 1, after the stop of another operator: $(cat "$2")"
  grep -q 'another operator stopped the axis' "$2" || fail "the stop of another operator: $(cat "$2")"
  ! grep -q 'still waits' "$2" || fail "nothing waits after a stop: $(cat "$2")"
}

# ---- a group
run plotter/machine.toml plotter
orders=
for k in 1 2 3 4; do
  "$jounce" order plotter move-linear x=$((10 * k)) y=0 --velocity 50 --buffered > "order$k" 2>&1 &
  orders="$orders $!"
done
for each in $orders; do
  wait "$each" || fail "orders at the same time: $(cat order1 order2 order3 order4)"
done
wait_for plotter '"state":"standstill".*"queue_rows":0'
answers 'the limits lower the velocity from 50000 mm/s to ' plotter move-linear x=60 y=60 --velocity 50000
refused 1 'VALUE = -1 s: must be from 0 s to 1e6 s' plotter wait -1

# An axis of the group is stopped: the group stops with it, and the jog reports it.
jogs_until 'the jog has ended: group_stopped' plotter 2 --along 0,1

# An axis is lost in motion: each override is accepted, and moves nothing.
order plotter move-linear x=0 y=0 --velocity 10 || fail "the line: $(cat out)"
order y disable || fail "y: $(cat out)"
wait_for plotter '"state":"error_stop"'
order y reset || fail "y: $(cat out)"
order y enable || fail "y: $(cat out)"
for factor in 0% 100% 50%; do answers 'takes effect when the motion continues' plotter override $factor; done
answers 'takes effect when the motion continues' plotter set-override --velocity-factor 80%
wait_for plotter '"state":"error_stop"'
order plotter disable || fail "plotter: $(cat out)"

# ---- the motion of one operator, stopped by the other one
jogs_until 'another operator stopped the axis' x 2
order x move --to 20 --at 1000000000 || fail "a later move: $(cat out)"
answers 'does not wait for the command of tick 1000000000' x move --to 10
"$jounce" stop x > out 2>&1 || fail "stop x: $(cat out)"
end

# ---- a robot with joints of two units
run scara/machine.toml robot
refused 1 'a1.position -\?[0-9.e-]* deg.*position_min of the axis, 5 deg' robot move-linear x=530 y=146 z=0
end

# ---- a knife with two blades
cat > line.toml << 'END'
jounce = 1
kind = "queue"
name = "line"
units = { position = "mm" }
[dynamics]
velocity = 100
acceleration = 800
jerk = 8000
[[command]]
type = "absolute"
position = 100000
END
cat > drum.toml << 'END'
jounce = 1
kind = "axis"
name = "drum"
units = { position = "deg", master = "mm" }
[axis]
cycle = "1 ms"
modulo = 360
[limits]
velocity = "260 rev/min"
acceleration = "400 rad/s^2"
END
cat > cuts.toml << 'END'
jounce = 1
kind = "machine"
[master.line]
kind = "table"
file = "line.toml"
unit = "mm"
velocity = 700
acceleration = 900
[[axis]]
spec = "drum.toml"
follow = { master = "line" }
END
cat > knife.toml << 'END'
jounce = 1
kind = "knife"
name = "k170"
units = { position = "deg", master = "mm" }
[knife]
diameter = 120
blades = 2
cut_length = 170
sync_angle = 24
dwell = true
[coupling]
start = "ramp_in"
velocity_diff = 300
acceleration = 2000
[master]
velocity = 700
acceleration = 900
distance = 3000
[limits.slave]
velocity = "260 rev/min"
acceleration = "400 rad/s^2"
END
patient drum.toml
run cuts.toml drum
knife() { "$jounce" stream knife.toml --to drum --live "$@"; }
# An odd number of cuts is half a turn.
knife --start-at 170mm --no-wait > out 2>&1 || fail "the knife: $(cat out)"
grep -q 'its master is at 0 mm, and rests' out || fail "the place of the master: $(cat out)"
wait_for drum '"master":0.0.*"waits":"until its master passes 170 mm"'
order line start || fail "the line: $(cat out)"
wait_for drum '"state":"synchronized_motion"'
"$jounce" stop drum > out 2>&1 || fail "stop drum: $(cat out)"
# The line has passed the position: the streamer waits, until the other operator stops the axis.
knife --start-at 170mm > waits 2>&1 &
waiting=$!
soon grep -q 'its master is at .* mm, and moves away from 170 mm' waits || fail "a passed position: $(cat waits)"
"$jounce" stop drum > out 2>&1 || fail "stop drum: $(cat out)"
stopped $waiting waits
end
echo "two operators are answered"
