# SPDX-License-Identifier: Apache-2.0
# Sourced by a script whose first argument is JOUNCE: runs the script in scripts/own_network, where nothing leaves
# this machine, with a scratch folder that goes away, and makes its first argument the jounce that meets others there.
root=$(cd "$(dirname "$0")/../.." && pwd)
if [ "${JOUNCE_INSIDE:-}" != 1 ]; then
  JOUNCE_INSIDE=1 exec "$root/scripts/own_network" "$0" "$@"
fi
export JOUNCE_EXE="$1"
shift
set -- "$root/tests/cli/bus/jounce" "$@"
# An executor that waits for the processor behind other tests stops its axis, as it should.
renice -n -10 -p $$ > /dev/null 2>&1 || true
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "FAILED: $1" >&2; exit 1; }
jounce=$1

# On a busy machine a command or a cycle can come a second late. A script therefore waits for a state or a position, not for
# a time within which a program should have reached it.

# patient SPEC...: a late cycle or message is no fault of these axes.
patient() { sed -i 's/^cycle.*/&\nlongest_gap = "30 s"\nsession_timeout = "10 s"/' "$@"; }
# soon COMMAND...: repeats COMMAND until it succeeds, 100 times at most.
soon() {
  for _ in $(seq 100); do
    "$@" > /dev/null 2>&1 && return 0
    sleep 0.2
  done
  return 1
}
# shows NAME PATTERN: the present status of an axis, a group or a master matches PATTERN; it is in $scratch/status.
shows() {
  "$jounce" monitor "$1" --seconds 0.3 --json 2> /dev/null | grep "^{\"name\":\"$1\",\"state\"" | tail -1 > "$scratch/status"
  grep -q -- "$2" "$scratch/status"
}
# wait_for NAME PATTERN: waits until its status matches PATTERN.
wait_for() { soon shows "$1" "$2" || fail "no status of $1 with $2: $(cat "$scratch/status")"; }
# position NAME: its present position.
position() {
  wait_for "$1" '"position":'
  sed 's/.*"position":\([-0-9.e+]*\).*/\1/' "$scratch/status"
}
# past NAME POSITION: it has passed POSITION upwards.
past() { awk -v now="$(position "$1")" -v least="$2" 'BEGIN { exit !(now >= least) }'; }
# played SPEC LOG: the log has the motion of SPEC. Cycles may be missing where they came late.
played() {
  "$jounce" validate "$1" --log "$2" --json > "$scratch/validated" || true
  python3 - "$scratch/validated" << 'END'
import json, sys
with open(sys.argv[1]) as file:
    findings = json.load(file)["findings"]
broken = [one for one in findings if one["broken"] and one["rule"] != "played/gap"]
compared = any(one["rule"] == "played/table" for one in findings)
sys.exit(0 if compared and not broken else f"the log was not compared, or: {broken}")
END
}
# order ARGUMENTS...: `jounce order`; it prints to the file out.
order() { "$jounce" order "$@" > out 2>&1; }
# refused STATUS WORDS ARGUMENTS...: the order ends with this exit status and prints these words.
refused() {
  status=$1
  words=$2
  shift 2
  got=0
  order "$@" || got=$?
  [ $got = "$status" ] || fail "$*: exit status $got, not $status: $(cat out)"
  grep -q -- "$words" out || fail "$*: not '$words': $(cat out)"
}
# Ends a test that needs a network of its own where there is none.
needs_network() {
  case $JOUNCE_BUS in unix:*) echo "skipped: $1 needs a network namespace"; exit 77 ;; esac
}
