#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# developer.sh CONSUMER_SOURCE_DIR: builds programs with the package libjounce-dev: one for each module with CMake, and two with
# pkg-config.
set -eu
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cmake -G Ninja -S "$1" -B "$scratch/build" > "$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
cmake --build "$scratch/build" > "$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
"$scratch/build/consumer"
for program in "$scratch"/build/use_*; do
  "$program" || { echo "developer: $program fails"; exit 1; }
done
for module in profiles:main.cpp base:use_base.cpp; do
  source=$(find "$1" "$scratch/build/sources" -name "${module#*:}")
  # shellcheck disable=SC2046
  g++ -std=c++20 "$source" -o "$scratch/alone" $(pkg-config --cflags --libs --static "jounce-${module%:*}")
  "$scratch/alone"
done
