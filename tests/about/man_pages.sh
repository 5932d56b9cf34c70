#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# man_pages.sh JOUNCE: each verb has a manual page, with each of its options. mandoc or man, if one of them is
# installed, accepts all pages without a warning.
set -u
jounce=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failed=0
report() { echo "$*"; failed=1; }

"$jounce" man "$scratch" || exit 1
verbs=$("$jounce" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z]*\) .*/\1/p')
[ "$(echo "$verbs" | wc -w)" -gt 20 ] || report "too few verbs in --help: $verbs"
for verb in $verbs; do
  page=$scratch/jounce-$verb.1
  [ -s "$page" ] || { report "$verb has no page"; continue; }
  grep -q "^\\\\fBjounce\\\\-$verb\\\\fR(1)$" "$scratch/jounce.1" || report "jounce.1 does not list $verb"
  for option in $("$jounce" "$verb" --help | sed -n 's/^  \(-[^ ]*\).*/\1/p' | tr , ' '); do
    grep -qF -- "\\fB${option//-/\\-}\\fR" "$page" || report "$page lacks $option"
  done
done
for page in "$scratch"/*.1; do
  sections=$(grep -c '^\.SH ' "$page")
  head -2 "$page" | grep -q '^\.TH ' && [ "$sections" -ge 4 ] || report "$page: no heading, or too few sections"
  # No line is a request of roff by accident.
  grep -nE "^['.]" "$page" | grep -vE '^[0-9]+:\.(TH|SH|TP|nf|fi|\\")' && report "$page: unknown requests"
  if command -v mandoc > /dev/null; then
    mandoc -Tlint -W warning "$page" || report "$page: mandoc warns"
  elif command -v man > /dev/null; then
    warnings=$(LC_ALL=C.UTF-8 MANROFFSEQ='' man --warnings -E UTF-8 -l -Tutf8 -Z "$page" 2>&1 > /dev/null)
    [ -z "$warnings" ] || report "$page: $warnings"
  fi
done
exit $failed
