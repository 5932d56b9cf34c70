#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# laws_are_printed.sh JOUNCE DOCS: docs/laws.md and its pictures are what `jounce laws` makes.
set -eu
"$1" laws --markdown | diff - "$2/laws.md"
count=0
for law in $(sed -n 's|.*(pictures/laws/\(.*\)\.svg)|\1|p' "$2/laws.md"); do
  "$1" laws "$law" -o law.svg
  cmp law.svg "$2/pictures/laws/$law.svg"
  count=$((count + 1))
done
test "$count" -gt 15
