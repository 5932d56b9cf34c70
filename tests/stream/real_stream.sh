#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# real_stream.sh PROGRAM: whole streams between two links, through Unix sockets and, where scripts/own_network gives
# a network namespace, over UDP multicast, of which not one packet reaches a real network.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
[ "${JOUNCE_INSIDE:-}" = 1 ] || JOUNCE_INSIDE=1 exec timeout 100 "$root/scripts/own_network" "$0" "$@"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$1" stream "unix://$scratch/bus"
case $JOUNCE_BUS in
udpm:*)
  ip route del 224.0.0.0/4 dev lo
  "$1" no-route "$JOUNCE_BUS?ttl=1"
  "$1" stream "$JOUNCE_BUS"  # needs no route: it stays on the loopback interface
  ip route add 224.0.0.0/4 dev lo
  "$1" lcm "$JOUNCE_BUS"
  ;;
esac
