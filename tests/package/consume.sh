#!/bin/sh
# Installs the build tree into a folder of its own and builds a ten-line consumer against it.
#   consume.sh BUILD_DIR CONSUMER_SOURCE_DIR
set -eu
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cmake --install "$1" --prefix "$scratch/prefix" > "$scratch/install.log" || { cat "$scratch/install.log"; exit 1; }
cmake -G Ninja -S "$2" -B "$scratch/build" -DCMAKE_PREFIX_PATH="$scratch/prefix" > "$scratch/log" || { cat "$scratch/log"; exit 1; }
cmake --build "$scratch/build" >> "$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
[ "$("$scratch/build/consumer")" = "1300 ms, at most 50 pulse/ms" ]
