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
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "FAILED: $1"; exit 1; }
# Ends a test that needs a network of its own where there is none.
needs_network() {
  case $JOUNCE_BUS in unix:*) echo "skipped: $1 needs a network namespace"; exit 77 ;; esac
}
