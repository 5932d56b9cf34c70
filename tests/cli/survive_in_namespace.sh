#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# survive_in_namespace.sh JOUNCE WHAT EXAMPLE_DIR [HELPER]: what real processes live through, in a network of
# their own. WHAT is
#     streamer   kill -9 of the streamer at many points of download, arm, start and play
#     declared   kill -9 of the streamer in play: a controlled stop, or the table finished, as declared
#     executor   kill -9 of the executor while it plays, and while it is sent a table
#     flood      100 000 foreign and malformed messages a second while a table is sent and played
#     disk       the disk of the log is full while a table is played
#     clock      the wall clock of both sides steps by hours, twenty times a second
set -eu
. "$(dirname "$0")/namespace.sh"
jounce=$1 what=$2 example=$3
cp "$example/axis.toml" "$scratch"
patient "$scratch/axis.toml"
sed -i '/^session_timeout/d' "$scratch/axis.toml"  # 1 s: it is waited for

play() { "$jounce" stream "$example/cam.toml" --to feeder "$@"; }
# The log: no setpoint is further from the one before than the limits of axis.toml allow in that time,
# neither in position nor in velocity (a stop may take twice the acceleration).
check_log() {
  awk -F, 'NR > 1 {
      if (NR > 2) {
        n = $1 - tick; dp = $6 - p; dv = $7 - v
        if (dp > 1 * n + 1e-6 || -dp > 1 * n + 1e-6) { print "position leaps at tick " $1; bad = 1 }
        if (dv > 40 * n + 1e-6 || -dv > 40 * n + 1e-6) { print "velocity leaps at tick " $1; bad = 1 }
        if ($3 ~ /standstill|disabled|error_stop/ && $7 != 0) { print "moves in " $3 " at tick " $1; bad = 1 }
        if (n < 1) { print "time goes back at tick " $1; bad = 1 }
      }
      tick = $1; p = $6; v = $7
    } END { exit bad }' "$1" || fail "the log breaks the limits"
}

case $what in
streamer)
  # A long table, so that the download takes a while, and a cam that plays for 5.4 s.
  sed 's/^rule = .*/rule = "linear"\nintervals = 400000/' "$example/cam.toml" > "$scratch/long.toml"
  "$jounce" run "$scratch/axis.toml" --enable --watchdog 30 --log "$scratch/run.csv" --seconds 60 --adopt-start 2> "$scratch/notices" &
  executor=$!
  wait_for feeder standstill
  seed=${SEED:-1}
  for try in $(seq 8); do
    seed=$((seed * 1103515245 % 2147483648 + 12345))
    delay=$((seed / 65536 % 900))
    if [ $((try % 2)) = 0 ]; then file=$scratch/long.toml; else file=$example/cam.toml; fi
    "$jounce" stream "$file" --to feeder --inject-loss 0.1 --seed $try > /dev/null 2>&1 &
    streamer=$!
    sleep 0.$(printf %03d $delay)
    kill -9 $streamer 2> /dev/null || true
    wait $streamer 2> /dev/null || true
    # The owner has gone: within its time-out, and a stop or the end of the table, the axis is still and free.
    wait_for feeder '"velocity":0.*"error":0'
    wait_for feeder standstill
  done
  sleep 1.2
  play || fail "the axis is not free"
  wait_for feeder standstill
  kill -TERM $executor
  wait $executor || fail "the executor ended badly: $(cat "$scratch/notices")"
  check_log "$scratch/run.csv"
  ;;
declared)
  # Its owner is killed in mid-play, waiting for a swap: stopped within its time-out, or played to its end.
  for declared in stopped finished; do
    flag=""
    [ $declared = finished ] && flag=--finish-when-silent
    "$jounce" run "$scratch/axis.toml" --enable --watchdog 30 --adopt-start $flag --json --log "$scratch/$declared.csv" --seconds 60 > "$scratch/$declared" 2> "$scratch/notices" &
    executor=$!
    wait_for feeder standstill
    "$jounce" stream "$example/cam.toml" --to feeder --swap "$example/cam.toml" --swap "$example/cam.toml" > "$scratch/out" 2>&1 &
    streamer=$!
    wait_for feeder synchronized_motion
    kill -9 $streamer || fail "the streamer had gone: $(cat "$scratch/out")"
    wait $streamer 2> /dev/null || true
    wait_for feeder standstill
    kill -TERM $executor
    wait $executor || fail "the executor ended badly: $(cat "$scratch/notices")"
    tr -d ' \n' < "$scratch/$declared" > "$scratch/line"
    if [ $declared = stopped ]; then
      grep -q '"finished":0,.*"stopped":1' "$scratch/line" || fail "not stopped: $(cat "$scratch/$declared")"
    else
      grep -q '"finished":[12],.*"stopped":0' "$scratch/line" || fail "not played to its end: $(cat "$scratch/$declared")"
    fi
    check_log "$scratch/$declared.csv"
  done
  ;;
executor)
  "$jounce" run "$scratch/axis.toml" --enable --watchdog 30 --seconds 60 2> /dev/null &
  executor=$!
  wait_for feeder standstill
  play || fail "the stream did not complete"
  wait_for feeder synchronized_motion
  kill -9 $executor
  wait $executor 2> /dev/null || true
  "$jounce" run "$scratch/axis.toml" --seconds 60 --log "$scratch/run.csv" 2> "$scratch/notices" &
  executor=$!
  wait_for feeder disabled  # no program has enabled it
  sleep 1
  grep -q started "$scratch/notices" && fail "it moved by itself after its restart"
  # Killed while it is sent a table: the stream ends, whole at the new executor or with a named error.
  sed 's/^rule = .*/rule = "linear"\nintervals = 400000/' "$example/cam.toml" > "$scratch/long.toml"
  "$jounce" stream "$scratch/long.toml" --to feeder --inject-loss 0.5 --until download --patience 40 > "$scratch/out" 2>&1 &
  streamer=$!
  sleep 1.5
  kill -9 $executor
  wait $executor 2> /dev/null || true
  "$jounce" run "$scratch/axis.toml" --enable --watchdog 30 --seconds 60 2> "$scratch/notices" &
  executor=$!
  if wait $streamer; then
    grep -q downloaded "$scratch/out" || fail "no outcome: $(cat "$scratch/out")"
    grep -q "400001 knots" "$scratch/notices" || fail "downloaded, but not to the executor that lives"
  else
    grep -q "restarted\|contact_lost\|out_of_time\|stalled" "$scratch/out" || fail "no named error: $(cat "$scratch/out")"
  fi
  wait_for feeder standstill
  kill -TERM $executor
  wait $executor || fail "the executor ended badly"
  ;;
flood)
  "$jounce" run "$scratch/axis.toml" --enable --watchdog 30 --log "$scratch/run.csv" --once --seconds 60 2> "$scratch/notices" &
  executor=$!
  wait_for feeder standstill
  "$4" "$JOUNCE_BUS" 100000 feeder > "$scratch/flood" &
  flood=$!
  sleep 0.3
  play || fail "the stream did not complete in the flood"
  wait $executor || fail "the executor ended badly in the flood: $(cat "$scratch/notices")"
  kill $flood
  wait $flood 2> /dev/null || true
  cat "$scratch/flood"
  played "$example/cam.toml" "$scratch/run.csv" || fail "another motion was played"
  check_log "$scratch/run.csv"
  ;;
clock)
  export CLOCK_STEPS=$scratch/readings
  LD_PRELOAD=$4 "$jounce" run "$scratch/axis.toml" --enable --watchdog 30 --log "$scratch/run.csv" --once \
    --seconds 60 2> "$scratch/notices" &
  executor=$!
  wait_for feeder standstill
  LD_PRELOAD=$4 "$jounce" stream "$example/cam.toml" --to feeder --inject-loss 0.1 || fail "the stream did not complete"
  wait $executor || fail "the executor ended badly: $(cat "$scratch/notices")"
  [ "$(wc -l < "$scratch/readings")" = 2 ] || fail "the clock was not stepped on both sides"
  echo "wall clock read: $(tr '\n' ' ' < "$scratch/readings")times"
  # The steps are there: a program that reads the clock reads them.
  rm "$scratch/readings"
  LD_PRELOAD=$4 date > /dev/null
  grep -q "^0$" "$scratch/readings" && fail "the clock is not stepped: a program that reads it counts no reading"
  played "$example/cam.toml" "$scratch/run.csv" || fail "another motion was played"
  check_log "$scratch/run.csv"
  ;;
disk)
  # A full disk of 64 KiB; where none may be mounted, a limit of as much for each file.
  mkdir "$scratch/full"
  status=0 reason="No space left"
  mount -t tmpfs -o size=64k tmpfs "$scratch/full" 2> /dev/null || {
    reason="File too large"
    trap '' XFSZ
    ulimit -S -f 128
  }
  "$jounce" run "$scratch/axis.toml" --enable --watchdog 30 --log "$scratch/full/run.csv" --once --seconds 60 > "$scratch/out" 2> "$scratch/notices" &
  executor=$!
  wait_for feeder standstill
  play || fail "the stream did not complete"
  wait $executor || status=$?
  cat "$scratch/notices"
  grep -q "^finished" "$scratch/notices" || fail "the motion was not finished"
  [ $status = 3 ] || fail "a log that cannot be written is a fault of the machine, not $status"
  grep -q "$reason" "$scratch/notices" || fail "no message gives the reason"
  grep -q "full/run.csv.truncated" "$scratch/notices" || fail "no message names the written file"
  [ ! -e "$scratch/full/run.csv" ] || fail "a log that is not whole has the name of one that is"
  check_log "$scratch/full/run.csv.truncated"
  umount "$scratch/full" 2> /dev/null || true
  # The black box: the one before stays readable, the terminal and the status name the one that is missing.
  mkdir "$scratch/box"
  mount -t tmpfs -o size=2m tmpfs "$scratch/box" 2> /dev/null || exit 0
  "$jounce" run "$scratch/axis.toml" --enable --watchdog 30 --black-box "$scratch/box/fault.lcmlog" --seconds 60 2> "$scratch/notices" &
  executor=$!
  wait_for feeder standstill
  "$jounce" stop feeder --abort
  wait_for feeder '"error":[1-9]'
  grep -q '"unwritten":""' "$scratch/status" || fail "a black box that was written is called missing"
  "$jounce" order feeder reset
  dd if=/dev/zero of="$scratch/box/filler" bs=1k 2> /dev/null || true
  "$jounce" stop feeder --abort
  wait_for feeder '"unwritten":"black box"'
  [ "$(grep -c "no black box: .*No space left" "$scratch/notices")" = 1 ] || fail "not reported once: $(cat "$scratch/notices")"
  "$jounce" replay "$scratch/box/fault.lcmlog" > "$scratch/replay" || fail "the black box from before is not readable"
  kill -TERM $executor
  wait $executor && fail "a black box that cannot be written is a fault of the machine"
  umount "$scratch/box"
  ;;
esac
