# SPDX-License-Identifier: Apache-2.0
# Sourced after namespace.sh: a second network, joined to this one by a cable: here 10.7.0.1, there 10.7.0.2.
# there COMMAND...: runs it in the other one. Ends with the test. Exit 77 where the kernel has no such cable.
ip route del 224.0.0.0/4 dev lo
ip link add name here type veth peer name there 2> /dev/null || { echo "skipped: no veth here"; exit 77; }
unshare -n sleep 120 &
other=$!
trap 'kill $other 2> /dev/null; rm -rf "$scratch"' EXIT
there() { nsenter -t $other -n "$@"; }
tries=0
while [ "$(readlink /proc/$other/ns/net)" = "$(readlink /proc/self/ns/net)" ]; do  # until it has one of its own
  tries=$((tries + 1))
  [ $tries -lt 100 ] || fail "no second network"
  sleep 0.05
done
ip link set there netns $other
ip addr add 10.7.0.1/24 dev here
ip link set here up
there sh -c 'ip link set lo up; ip addr add 10.7.0.2/24 dev there; ip link set there up
  ip route add 239.255.76.67/32 dev there'
ip route add 239.255.76.67/32 dev here
