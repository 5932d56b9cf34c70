#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# pairs_in_namespace.sh JOUNCE EXAMPLE_DIR: of two executors of one name that start together, one is up and the other ends
# with an error that names it; on one machine, and on two that a cable joins; and 64 axes are up together.
set -eu
. "$(dirname "$0")/namespace.sh"
jounce=$1 example=$2

# one NAME [COMMAND...]: starts an executor; its exit status and its output are in files.
one() {
  name=$1 mark=$2
  shift 2
  status=0
  "$@" "$jounce" run "$scratch/$name.toml" $url --seconds 4 > "$scratch/$mark.out" 2> "$scratch/$mark.err" || status=$?
  echo $status > "$scratch/$mark.status"
}

# judge NAME: one of the two of this name was up to its end, and the other one gives the reason why it was not.
judge() {
  statuses=$(cat "$scratch/$1-a.status" "$scratch/$1-b.status" | sort | tr '\n' ' ')
  case $statuses in
  "0 2 " | "0 3 ") ;;
  *) fail "$1: exit statuses $statuses: $(cat "$scratch/$1"-?.err)" ;;
  esac
  cat "$scratch/$1-a.err" "$scratch/$1-b.err" | grep -q "another executor on this --url" ||
    fail "$1: the one that left gives no reason: $(cat "$scratch/$1"-?.err)"
}

pairs() {
  for i in $(seq "$1"); do
    sed "s/^name = .*/name = \"pair$i\"/" "$example/axis.toml" > "$scratch/pair$i.toml"
    one "pair$i" "pair$i-a" &
    one "pair$i" "pair$i-b" ${2:-} &
  done
  wait_for_all "$1"
  for i in $(seq "$1"); do judge "pair$i"; done
  rm -f "$scratch"/pair*
}

wait_for_all() {
  tries=0
  while [ "$(ls "$scratch"/pair*.status 2> /dev/null | wc -l)" -lt $((2 * $1)) ]; do
    tries=$((tries + 1))
    [ $tries -lt 600 ] || fail "not all executors have ended"
    sleep 0.1
  done
}

url=
pairs 12

# Many axes come up together: all of them, in one claim.
mkdir "$scratch/axes"
for i in $(seq 64); do
  sed "s/^name = .*/name = \"a$i\"/" "$example/axis.toml" > "$scratch/axes/a$i.toml"
done
"$jounce" run "$scratch"/axes/*.toml --seconds 1 --json > "$scratch/many" 2> "$scratch/many.err" ||
  fail "64 axes: $(cat "$scratch/many.err")"
[ "$(grep -c '"name"' "$scratch/many")" = 64 ] || fail "not all axes ran"

case $JOUNCE_BUS in unix:*) exit 0 ;; esac  # two machines need a network
ip link add name here type veth peer name there 2> /dev/null || { echo "no veth here: one machine only"; exit 0; }
unshare -n sleep 100 &
other=$!
trap 'kill $other 2> /dev/null; rm -rf "$scratch"' EXIT
tries=0
while [ "$(readlink /proc/$other/ns/net)" = "$(readlink /proc/self/ns/net)" ]; do
  tries=$((tries + 1))
  [ $tries -lt 100 ] || fail "no second network"
  sleep 0.05
done
ip route del 224.0.0.0/4 dev lo
ip link set there netns $other
ip addr add 10.7.0.1/24 dev here
ip link set here up
nsenter -t $other -n sh -c 'ip link set lo up; ip addr add 10.7.0.2/24 dev there; ip link set there up
  ip route add 239.255.76.67/32 dev there'
ip route add 239.255.76.67/32 dev here
url='--url udpm://239.255.76.67:7667?ttl=1'
pairs 6 "nsenter -t $other -n"
