#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# scope_in_browser.sh JOUNCE: the traces of a cam with 120 periods in a minute, in headless Chromium; 77: there is none.
set -eu
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
[ -n "$browser" ] || { echo "skipped: no Chromium is installed"; exit 77; }
. "$(dirname "$0")/../cli/namespace.sh"
cat > "$scratch/feeder.toml" << 'END'
jounce = 1
kind = "axis"
name = "feeder"
units = { position = "mm", master = "deg" }
[axis]
cycle = "1 ms"
longest_gap = "20 s"  # a loaded machine skips cycles
[limits]
velocity = 1000
acceleration = 20000
position_min = -10
position_max = 300
END
sed 's/"feeder"/"knife"/' "$scratch/feeder.toml" > "$scratch/knife.toml"
cat > "$scratch/cam.toml" << 'END'
jounce = 1
kind = "cam"
name = "fast"
periodic = true
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }
[[segment]]
law = "modified_sine"
end = { master = 180, slave = 40 }
[[segment]]
law = "modified_sine"
end = { master = 360, slave = 0 }
[master]
velocity = 720
distance = 36000
[table]
rule = "quintic_hermite"
intervals = 360
END
: > "$scratch/said"
"$1" run "$scratch/feeder.toml" "$scratch/knife.toml" --enable --web 0 --seconds 150 2> "$scratch/said" &
executor=$!
trap 'kill -KILL $executor 2> /dev/null || true; rm -rf "$scratch"' EXIT
for turn in $(seq 100); do
  address=$(sed -n 's/.* live page at //p' "$scratch/said")
  [ -z "$address" ] || break
  sleep 0.1
done
[ -n "$address" ] || fail "no address is printed: $(cat "$scratch/said")"
"$1" stream "$scratch/cam.toml" --to feeder > "$scratch/stream" 2>&1 || fail "$(cat "$scratch/stream")"
timeout 130 python3 "$(dirname "$0")/scope_in_browser.py" "$browser" "$scratch" "$address" || fail "see above"
