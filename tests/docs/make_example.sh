#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# make_example.sh JOUNCE SPEC PICTURE: the spec is designed, checked, proven and drawn; its tables read back; the picture
# in docs/ is the one it draws (scripts/pictures makes them anew).
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$1" design "$2" -o "$folder/table.csv"
for table in "$folder"/*.csv; do "$1" check "$table"; done
"$1" check "$2"
"$1" validate "$2"
"$1" plot "$2" -o "$folder/picture.svg"
cmp "$folder/picture.svg" "$3"
