# Sourced: runs the function `inside` in a network namespace of its own, with multicast on loopback
# only, and a scratch folder that goes away.
if [ "${JOUNCE_INSIDE:-}" != 1 ]; then
  if unshare -rnm true 2> /dev/null; then isolate="unshare -rnm"; else isolate="unshare -nm"; fi
  JOUNCE_INSIDE=1 exec $isolate "$0" "$@"
fi
ip link set lo up
ip route add 224.0.0.0/4 dev lo
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "FAILED: $1"; exit 1; }
