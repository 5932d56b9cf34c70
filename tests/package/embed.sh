#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Builds examples/library with its CMakeLists.txt, which adds Jounce's sources with add_subdirectory, and `profiles` of them:
# no other library is looked for, neither tests nor programs are added, and headers are not precompiled.
#   embed.sh JOUNCE_SOURCE_DIR
set -eu
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
logged() { "$@" >> "$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }; }
logged cmake -G Ninja -S "$1/examples/library" -B "$scratch/build" -DCMAKE_BUILD_TYPE= -DCMAKE_CXX_FLAGS=-O0
if grep -iE 'nlopt|sundials|fmt|Eigen|lcm' "$scratch/log"; then exit 1; fi
targets=$(cmake --build "$scratch/build" --target help)
for target in jounce_cam jounce_base jounce_cli test_profiles cmake_pch Unity; do
  case $targets in *$target*) echo "$target is added"; exit 1 ;; esac
done
grep -q '^JOUNCE_PCH:BOOL=OFF$' "$scratch/build/CMakeCache.txt"
grep -q '^JOUNCE_UNITY:BOOL=OFF$' "$scratch/build/CMakeCache.txt"
grep -q '^JOUNCE_LEVELS:BOOL=OFF$' "$scratch/build/CMakeCache.txt"
logged cmake --build "$scratch/build" --target first_move
sed -n 's|^// > ||p' "$1/examples/library/01_move.cpp" > "$scratch/wanted"
"$scratch/build/first_move" | diff "$scratch/wanted" -

# The installation of a program that contains Jounce does not contain Jounce.
logged cmake --install "$scratch/build" --prefix "$scratch/prefix"
if [ -n "$(find "$scratch/prefix" -type f 2> /dev/null)" ]; then echo "Jounce is installed"; exit 1; fi
