# SPDX-License-Identifier: Apache-2.0
# Sourced after namespace.sh: an executor with a live page, whose address is $address; ends with the test.
"$1" new axis -o "$scratch/axis.toml"
: > "$scratch/said"  # the loop reads it before the program writes
"$1" run "$scratch/axis.toml" --enable --web 0 --seconds 500 2> "$scratch/said" &
executor=$!
trap 'kill -KILL $executor 2> /dev/null || true; rm -rf "$scratch"' EXIT
for turn in $(seq 600); do
  address=$(sed -n 's/.* live page at //p' "$scratch/said")
  [ -z "$address" ] || break
  sleep 0.1
done
[ -n "$address" ] || fail "no address is printed: $(cat "$scratch/said")"
