#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# matrix_in_namespace.sh JOUNCE WHAT EXAMPLE [DRIVE]: faults while a group plays a path and its override changes. WHAT is
#     sender     kill -9 of the sender during the download, and of a program that keeps the session in motion
#     drive      kill -9 of the drive of one axis
#     loss5      5 % of the packets are lost each way
#     loss20     20 % of the packets are lost each way
#     delay      the sender stands still again and again, so that its messages come late
#     stall      the executor stands still for a time that it tolerates, then for a longer one
#     disk       the disk of the log and of the record is full
#     partition  the network is down for some seconds
#     killed     kill -9 of the executor, and a new one in its place
# judge_contour.py checks the log by the limits of the axes and the polygon of the program.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/namespace.sh"
jounce=$1 what=$2 example=$3
cd "$scratch"
cp "$example"/*.toml .
patient x.toml y.toml
sed '/^\[\[command/,$d' square.toml > bed.toml
corners="0,0 60,0 60,10 0,10 0,20 60,20 60,30 0,30 0,0"
{
  echo 'G21 G90 G64 P0.1'
  for corner in $corners; do echo "G1 X${corner%,*} Y${corner#*,} F3000"; done
  echo M30
} > part.ngc
loss=""
case $what in
  loss5) loss="--inject-loss 0.05" ;;
  loss20) loss="--inject-loss 0.2" ;;
esac
folder=.
if [ "$what" = disk ]; then
  folder=full
  mkdir full
  mount -t tmpfs -o size=512k tmpfs full 2> /dev/null || { trap '' XFSZ; ulimit -S -f 1024; }
fi
if [ "$what" = stall ]; then sed -i 's/^longest_gap.*/longest_gap = "0.5 s"/' x.toml y.toml; fi
if [ "$what" = drive ]; then
  printf '[drive]\ntype = "shared_memory"\nname = "y-%s"\nincrements_per_rev = 100000\nposition_per_rev = 10\n' $$ >> y.toml
  "$4" y-$$ 100 > drive.txt 2>&1 &
  drive=$!
fi
run() {
  "$jounce" run machine.toml --enable --watchdog 30 --log $folder/run.csv --record $folder/run.lcmlog --seconds 100 $loss 2> said &
  executor=$!
  soon order plotter enable || fail "no executor: $(cat said out)"
}
stream() { "$jounce" stream part.ngc --machine bed.toml --to plotter $loss > out 2>&1; }
end() {  # end TICKS: the run ends, and its log is judged
  kill -TERM $executor
  wait $executor || [ $? = 1 ] || fail "the run: $(cat said)"
  python3 "$here/judge_contour.py" run.x.csv run.y.csv "$1" 0.1000001 $corners || fail "the judge of the log"
  "$jounce" replay run.lcmlog > out || fail "the replay: $(cat out)"
}
# overrides N: N changes of the override, one after another.
overrides() {
  for k in $(seq "$1"); do
    order plotter override $((30 + k * 37 % 70))% || fail "override: $(cat out)"
    sleep 0.2
  done
}
# plays: the program to its end, while the override changes.
plays() {
  stream || fail "stream: $(cat out)"
  overrides 12
  order plotter override 100% || fail "override: $(cat out)"
  wait_for plotter '"state":"standstill".*"error":0.*"reason":"none"'
}

run
case $what in
sender)
  for try in 1 2 3 4 5 6; do
    stream &
    sender=$!
    sleep 0.0$((try % 2))$((try * 13 % 10))
    kill -9 $sender 2> /dev/null || true
    wait $sender 2> /dev/null || true
    sleep 0.5
    overrides 2
    order plotter override 100% || fail "override: $(cat out)"
    wait_for plotter '"state":"standstill".*"error":0'
  done
  plays
  order plotter override 50% || fail "override: $(cat out)"
  "$jounce" order plotter jog --along 1,0 --velocity 20 --hold-to-run > jog 2>&1 &
  jog=$!
  wait_for plotter '"state":"discrete_motion"'
  kill -9 $jog
  wait $jog 2> /dev/null || true
  wait_for plotter '"state":"standstill"'
  position x > now
  awk '{ exit !($1 > 0 && $1 < 60) }' now || fail "the jog went on to $(cat now)"
  end 3000
  ;;
drive)
  order plotter disable || fail "disable: $(cat out)"
  order y move --to 0 || fail "move: $(cat out)"  # the drive begins elsewhere
  wait_for y '"state":"standstill".*"position":0.0,'
  order plotter enable || fail "enable: $(cat out)"
  stream || fail "stream: $(cat out)"
  soon past x 10 || fail "it does not move"
  overrides 2
  kill -9 $drive
  wait $drive 2> /dev/null || true
  wait_for plotter '"state":"error_stop"'
  wait_for x '"state":"standstill"'
  grep -q 'y: fault at tick .*drive_fault' said || fail "no fault of the drive: $(cat said)"
  refused 1 axis_not_ready plotter reset
  end 300
  ;;
loss5 | loss20)
  plays
  plays
  end 6000
  ;;
delay)
  for try in 1 2 3; do
    stream &
    sender=$!
    for k in 1 2 3 4; do
      sleep 0.05
      kill -STOP $sender 2> /dev/null || break
      sleep 0.$((k + try))
      kill -CONT $sender
    done
    wait $sender || fail "stream: $(cat out)"
    overrides 3
    order plotter override 100% || fail "override: $(cat out)"
    wait_for plotter '"state":"standstill".*"error":0.*"reason":"none"'
  done
  end 3000
  ;;
stall)
  stream || fail "stream: $(cat out)"
  soon past x 10 || fail "it does not move"
  for k in 1 2 3; do
    overrides 1
    kill -STOP $executor
    sleep 0.2
    kill -CONT $executor
  done
  wait_for plotter '"state":"discrete_motion".*"error":0'
  kill -STOP $executor
  sleep 1.5
  kill -CONT $executor
  wait_for plotter '"state":"error_stop"'
  grep -q stalled said || fail "no fault: $(cat said)"
  shows x '"velocity":0.0' || fail "x moves: $(cat "$scratch/status")"
  end 300
  ;;
disk)
  plays
  plays
  kill -TERM $executor
  got=0
  wait $executor || got=$?
  [ $got = 3 ] || fail "a full disk is a fault of the machine, not $got: $(cat said)"
  [ -e full/run.x.csv.truncated ] || [ -e full/run.plotter.csv.truncated ] || fail "no file is named as truncated: $(ls full)"
  for name in x y; do
    [ -e full/run.$name.csv ] && cp full/run.$name.csv . || cp full/run.$name.csv.truncated run.$name.csv
    sed -i '$d' run.$name.csv  # the last line may be cut
  done
  python3 "$here/judge_contour.py" run.x.csv run.y.csv 100 0.1000001 $corners || fail "the judge of the log"
  umount full 2> /dev/null || true
  ;;
partition)
  needs_network "a network that is down"
  stream || fail "stream: $(cat out)"
  soon past x 10 || fail "it does not move"
  overrides 2
  ip link set lo down
  refused 3 "is down" plotter override 20%
  sleep 2
  ip link set lo up
  ip route add 224.0.0.0/4 dev lo 2> /dev/null || true
  soon order plotter override 60% || fail "override after the return: $(cat out)"
  overrides 2
  order plotter override 100% || fail "override: $(cat out)"
  wait_for plotter '"state":"standstill".*"error":0.*"reason":"none"'
  end 3000
  ;;
killed)
  stream || fail "stream: $(cat out)"
  soon past x 10 || fail "it does not move"
  overrides 3
  shows plotter '"state":"discrete_motion"' || fail "it rests: $(cat "$scratch/status")"
  sed 's/.*"tick":\([0-9]*\).*/\1/' "$scratch/status" > seen
  kill -9 $executor
  wait $executor 2> /dev/null || true
  refused 3 "no message from plotter" plotter hold
  mkdir before
  mv run.*part before
  # The logs and the record reach the kill, except for the last moments. The last line may be cut.
  for name in x y; do sed '$d' before/run.$name.csv.$executor.part > run.$name.csv; done
  python3 "$here/judge_contour.py" run.x.csv run.y.csv 300 0.1000001 $corners || fail "the judge of the log"
  last=$(tail -n 1 run.x.csv | cut -d, -f1)
  [ "$last" -gt $(($(cat seen) - 2000)) ] || fail "the log ends at tick $last, long before $(cat seen)"
  "$jounce" replay before/run.lcmlog.part > out 2>&1 || fail "the replay: $(cat out)"
  rm run.x.csv run.y.csv
  # The new executor has no path and no place: the group begins at rest, and plays the program from its start.
  run
  wait_for plotter '"state":"standstill".*"error":0'
  refused 1 no_movement plotter resume
  plays
  end 3000
  ;;
esac
