#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# isolated_in_namespace.sh JOUNCE EXAMPLE_DIR: an executor in motion, and another machine on its network that has no
# key, receives nothing and sends: a stop, a master's position, a status with a text that is not UTF-8. It tests the
# statements of docs/executor/two-machines.md about each address: without a ttl; with ttl=1 and no key, where the same
# attacks succeed (so that they are attacks); with ttl=1 and a key.
set -eu
. "$(dirname "$0")/namespace.sh"
needs_network "another machine"
. "$(dirname "$0")/machines.sh"
jounce=$1 here=$(cd "$(dirname "$0")" && pwd)
cp "$2"/*.toml "$scratch"
cd "$scratch"
patient label.toml
attack() { there python3 "$here/attack.py" "$1" 10.7.0.1 10.7.0.2 "${2:-1}"; }
far='udpm://239.255.76.67:7667?ttl=1'

# begin OPTION...: an executor with these options in slow motion, which the functions below look at with $look.
begin() {
  "$jounce" run machine.toml --enable --watchdog 30 --seconds 60 "$@" 2> said &
  executor=$!
  look=$(echo " $* " | sed 's/ --web 0 / /')
  # shellcheck disable=SC2086
  soon "$jounce" order label jog 1mm/s $look || fail "the axis does not move: $(cat said)"
}
# warned: status 0: the page of this executor warns on top that every machine can move its axes; 1: no warning; 2: no page.
warned() {
  address=
  for _ in $(seq 50); do
    address=$(sed -n 's/.* live page at //p' said)
    [ -z "$address" ] || break
    sleep 0.1
  done
  python3 - "${address%#*}" <<'PAGE'
import sys
import urllib.request
with urllib.request.urlopen(sys.argv[1], timeout=10) as answer:
    page = answer.read().decode()
if "<main>" not in page:
    sys.exit(2)
sys.exit(0 if 'id="warning"' in page and "no --key" in page else 1)
PAGE
}
# page 0|1 WHEN: expects that status of warned.
page() {
  status=0
  warned || status=$?
  [ $status = "$1" ] || fail "$2: $([ $status = 2 ] && echo "there is no page" || echo "its page warns: $((1 - status))")"
}
end() { kill -INT $executor; wait $executor || true; }
sees() {  # the last line of each kind; repeats until there are both
  for _ in $(seq 50); do
    # shellcheck disable=SC2086
    "$jounce" monitor label --seconds 0.5 --json $look > seen
    grep '"state"' seen | tail -1 > axis
    grep '"master_name"' seen | tail -1 > master
    [ -s axis ] && [ -s master ] && return 0
  done
  fail "no status of the axis and its master: $(cat seen)"
}
moves() { sees; grep -q '"state":"continuous_motion"' axis; }
stands() { sees; grep -q '"state":"standstill"' axis; }
led() { sees; grep -q '"lost":false' master; }

begin --web 0
page 1 "an executor of this machine alone"
# On the same machine another program has joined the group on the interface that is attacked.
"$jounce" monitor --url "$far" --seconds 30 --silence 30 > /dev/null 2>&1 &
joined=$!
grep -q warning said && fail "an executor of this machine alone warns: $(cat said)"
attack STOP
moves || fail "without a ttl, another machine stopped the axis: $(cat axis)"
attack MASTER 2 &
led && fail "without a ttl, another machine was taken for the master: $(cat master)"
wait $!
attack TEXT
moves || fail "without a ttl, a text from another machine had an effect: $(cat axis)"
kill $joined
end
status=0
there "$jounce" monitor label --url "$far" --silence 1 --seconds 2 > /dev/null 2>&1 || status=$?
[ $status = 3 ] || fail "without a ttl the axis is seen on another machine"

begin --url "$far" --web 0
page 0 "without a key on a network"
grep -q 'warning.*no --key' said || fail "no warning without a key on a network: $(cat said)"
attack MASTER 6 &
soon led || fail "the attacks do not arrive, so nothing is tested: $(cat master)"
wait $!
attack TEXT
moves || fail "a text that is not UTF-8 had an effect: $(cat axis)"
attack STOP
soon stands || fail "the page states that a stop without a key is obeyed; it was not"
end

"$jounce" new key -o line.key > /dev/null
begin --url "$far" --key line.key --web 0
page 1 "with a key"
grep -q warning said && fail "it warns, though there is a key: $(cat said)"
attack STOP
moves || fail "with a key, another machine stopped the axis"
attack MASTER 2 &
led && fail "with a key, another machine was taken for the master"
wait $!
end
