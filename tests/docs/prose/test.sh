#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# test.sh PROSE: the script finds each stumble of the two files beside this one, in its line, and nothing else.
cd "$(dirname "$0")" || exit 3
found=$("$1" stumbles.md stumbles.hpp | grep -v ': spelling' | cut -d: -f1-3)
wanted='stumbles.hpp:4: begin
stumbles.hpp:5: verb
stumbles.hpp:6: begin
stumbles.md:3: verb
stumbles.md:3: word
stumbles.md:5: clause
stumbles.md:5: metaphor
stumbles.md:5: metaphor
stumbles.md:11: length
2 files: begin 2, clause 1, length 1, metaphor 2, verb 2, word 1'
[ "$found" = "$wanted" ] || { printf 'found:\n%s\nwanted:\n%s\n' "$found" "$wanted"; exit 1; }
