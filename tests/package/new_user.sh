#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# new_user.sh: the first steps with the package jounce, in an empty folder. Prints the time of a check of forty specs. Exit status 1
# if a step fails.
set -eu
examples=/usr/share/doc/jounce/examples
fail() { echo "new user: $1" >&2; exit 1; }
# status WANTED COMMAND...
status() {
  wanted=$1 got=0
  shift
  "$@" > out 2>&1 || got=$?
  [ $got = "$wanted" ] || { cat out; fail "'$*' ends with $got instead of $wanted"; }
}

echo "- version, manual pages, completion"
jounce --version > version
head -1 version | grep -qE '^jounce [0-9]+\.[0-9]+\.[0-9]+$' || fail "unexpected version: $(head -1 version)"
for page in jounce jounce-check jounce-stream; do
  zcat "/usr/share/man/man1/$page.1.gz" | grep -q '^\.SH EXIT STATUS' || fail "no manual page $page"
done
completed=$(bash -c 'source /usr/share/bash-completion/completions/jounce
  compopt() { :; }
  COMP_WORDS=(jounce check --format gi) COMP_CWORD=3
  _jounce jounce gi --format
  echo "${COMPREPLY[*]}"')
[ "$completed" = "github gitlab" ] || fail "bash completes '$completed'"

echo "- new, check, design, plot, optimize, validate"
status 0 jounce new cam -o feeder.toml
status 0 jounce check feeder.toml
status 0 jounce design feeder.toml -o feeder.csv
status 0 jounce plot feeder.toml -o feeder.svg
status 0 jounce validate feeder.toml
status 1 jounce check $examples/pmc600-cam/cam.toml
status 0 jounce optimize $examples/pmc600-cam/cam.toml -o better.toml
status 0 jounce check better.toml
status 0 jounce validate better.toml feeder.csv

echo "- run, stream, order"
bus=unix://$PWD/bus
jounce run $examples/pmc600-cam/axis.toml --url "$bus" --once --seconds 60 --log run.csv > run.out 2>&1 &
executor=$!
for try in $(seq 50); do jounce order feeder enable --url "$bus" > out 2>&1 && break || sleep 0.1; done
[ "$try" -lt 50 ] || { cat out; fail "the executor does not answer"; }
status 0 jounce stream better.toml --url "$bus" --to feeder
wait $executor || { cat run.out; fail "the executor does not finish the motion"; }
status 0 jounce validate better.toml --log run.csv

echo "- forty specs in the form of a CI system, and a broken limit"
mkdir motions
for i in $(seq 40); do
  sed "s/^name = .*/name = \"pusher$i\"/; s/slave = 180/slave = $((140 + i))/" $examples/packaging-pusher/cam.toml > "motions/pusher$i.toml"
done
begin=$(date +%s%N)
jounce check motions --format github > out 2>&1 || { cat out; fail "forty good specs are rejected"; }
end=$(date +%s%N)
echo "  jounce check of 40 specs: $(((end - begin) / 1000000)) ms"
grep -qx '40 files: 40 good' out || { cat out; fail "not 40 files"; }

cp $examples/pmc600-cam/cam.toml motions/broken.toml
status 1 jounce check motions --format github
line=$(sed -n 's/^::error .*file=motions\/broken\.toml,line=\([0-9]*\).*limit\/geo_velocity.*/\1/p' out)
[ -n "$line" ] || { cat out; fail "no annotation of the broken limit"; }
sed -n "${line}p" motions/broken.toml | grep -q '^\[\[segment\]\]' || fail "line $line is not the line of a segment"
echo "  $(grep -m1 '^::error' out)"

echo "- a cam goes to four controllers and back, within the stated error"
cam=$examples/to-controllers/feeder.toml
for format in codesys twincat siemens rockwell; do
  status 0 jounce convert $cam feeder.$format --to $format --json
  error=$(sed -n 's/.*"error":\([-0-9.e]*\).*/\1/p' out)
  status 0 jounce convert feeder.$format back.csv --master-unit deg --position-unit mm --periodic
  status 0 jounce diff $cam back.csv --tolerance "position=$error mm"
  echo "  $format: $error mm"
done
status 0 jounce convert $examples/to-controllers/lift.toml lift.yaml

echo "- a workbook and a drawing"
sed "s|\"points.csv\"|\"$examples/points-file/points.xlsx\"|" $examples/points-file/pvt.toml > excel.toml
status 0 jounce check excel.toml
status 0 jounce fit $examples/cam-plate/plate.dxf#PLATE --tolerance 5um -o plate.toml \
  --drawing 'roller_radius = 7, offset = -4, origin = [100, 80], turn = "-30 deg"'
status 0 jounce check plate.toml
