#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# machine_in_namespace.sh JOUNCE: a machine with a virtual master, over UDP: the logs of all its axes, and the messages
# about missing files and silent programs.
set -eu
. "$(dirname "$0")/namespace.sh"
cd "$scratch"
cat > feeder.toml <<'END'
jounce = 1
kind = "axis"
name = "feeder"
units = { position = "mm", master = "mm" }
[axis]
longest_gap = "30 s"
session_timeout = "10 s"
[limits]
velocity = 500
acceleration = 10000
END
cat > line.toml <<'END'
jounce = 1
kind = "move"
units = { position = "mm" }
[move]
profile = "trapezoid"
to = 50
velocity = 200
acceleration = 2000
END
cat > machine.toml <<'END'
jounce = 1
kind = "machine"
watchdog = "30 s"
[master.virtual]
kind = "table"
file = "line.toml"
unit = "mm"
velocity = 500
acceleration = 5000
[[axis]]
spec = "feeder.toml"
follow = { master = "virtual" }
END
"$1" run machine.toml --enable --log run.csv --seconds 8 2> said &
executor=$!
soon "$1" order virtual start || fail "the virtual master does not start: $(cat said)"
wait $executor || { cat said; fail "the run ended badly"; }
for axis in feeder virtual; do
  [ -f run.$axis.csv ] || fail "no log of $axis"
  head -1 run.$axis.csv | grep -q 'position \[mm\]' || fail "the log of $axis has no head"
done
tail -1 run.virtual.csv | cut -d, -f6 | grep -qx 50 || fail "the log of the virtual axis does not end at 50 mm"

"$1" stream line.toml --to nobody --patience 1 2> said && fail "somebody answered"
grep -q 'no answer from.*check that it is running, with the same --url and the same --key' said || fail "no hint: $(cat said)"
"$1" master line.toml --as line --noise 5deg 2> said && fail "degrees of a line in mm"
grep -q -- '--noise = "5deg"' said || fail "--noise is not named: $(cat said)"
"$1" master line.toml --as line --noise 20um --resolution 0.05 --epoch 3 --seconds 0.2 --before 0 --json > said ||
  fail "a master with noise"
sed 's/feeder.toml/nowhere.toml/' machine.toml > other.toml
"$1" run other.toml 2> said && fail "an axis that is not there was run"
grep -q 'other.toml:11:.*axis\[1\].spec = .*nowhere.toml: cannot be read' said || fail "not placed: $(cat said)"
sed 's/"line.toml"/"gone.toml"/' machine.toml > other.toml
"$1" run other.toml 2> said && fail "a master that is not there was run"
grep -q 'other.toml:6:.*master.virtual.file = .*gone.toml: cannot be read' said || fail "not placed: $(cat said)"
