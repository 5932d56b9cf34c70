#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# group_in_browser.sh JOUNCE EXAMPLES [PICTURES]: the planned paths of a robot and of a plotter on the live page, in
# headless Chromium; 77: there is none.
set -eu
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
[ -n "$browser" ] || { echo "skipped: no Chromium is installed"; exit 77; }
. "$(dirname "$0")/../cli/namespace.sh"
examples=$2
pictures=${3:-}
executor=
trap 'kill -KILL $executor 2> /dev/null || true; rm -rf "$scratch"' EXIT
for one in scara:robot plotter:plotter welding-head:head; do
  machine=${one%:*} group=${one#*:}
  cp -r "$examples/$machine" "$scratch/$machine"
  for spec in "$scratch/$machine"/*.toml; do
    ! grep -q '^\[axis\]' "$spec" || patient "$spec"
  done
  : > "$scratch/said"
  "$jounce" run "$scratch/$machine/machine.toml" --enable --web 0 --seconds 200 2> "$scratch/said" &
  executor=$!
  address=
  for turn in $(seq 300); do
    address=$(sed -n 's/.* live page at //p' "$scratch/said")
    [ -z "$address" ] || break
    sleep 0.1
  done
  [ -n "$address" ] || fail "no address is printed: $(cat "$scratch/said")"
  timeout 150 python3 "$(dirname "$0")/group_in_browser.py" "$browser" "$scratch" "$address" "$group" ${pictures:+"$pictures/$group"} ||
    fail "see above; $(cat "$scratch/said")"
  kill -INT $executor
  wait $executor || fail "the executor ended badly: $(cat "$scratch/said")"
done
