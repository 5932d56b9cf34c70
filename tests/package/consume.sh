#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Installs the build tree into a folder, moves that, and builds programs against it: with CMake, one for each module, and
# with pkg-config.
#   consume.sh BUILD_DIR CONSUMER_SOURCE_DIR
set -eu
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
logged() { "$@" >> "$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }; }
logged cmake --install "$1" --prefix "$scratch/installed"
mv "$scratch/installed" "$scratch/prefix"
logged cmake -G Ninja -S "$2" -B "$scratch/build" -DCMAKE_PREFIX_PATH="$scratch/prefix"
logged cmake --build "$scratch/build"
[ "$("$scratch/build/consumer")" = "1300 ms, at most 50 pulse/ms" ]
for program in "$scratch"/build/use_*; do
  "$program" || { echo "package: $program fails"; exit 1; }
done

folder=$(dirname "$(find "$scratch/prefix" -name jounce-profiles.pc)")
words() { PKG_CONFIG_PATH="$folder" pkg-config --cflags --libs --static "$1"; }
# shellcheck disable=SC2046
logged g++ -std=c++20 "$2/main.cpp" -o "$scratch/alone" $(words jounce-profiles)
[ "$("$scratch/alone")" = "1300 ms, at most 50 pulse/ms" ]
# shellcheck disable=SC2046
logged g++ -std=c++20 "$scratch/build/sources/use_base.cpp" -o "$scratch/base" $(words jounce-base)
"$scratch/base"

# The installed examples are found by CMake, and compile without a warning.
logged cmake -G Ninja -S "$scratch/prefix/share/doc/libjounce-dev/examples" -B "$scratch/examples" \
  -DCMAKE_PREFIX_PATH="$scratch/prefix" -DCMAKE_NO_SYSTEM_FROM_IMPORTED=ON \
  -DCMAKE_CXX_FLAGS="-std=c++20 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"
logged cmake --build "$scratch/examples" --target first_move --target 24_gears
"$scratch/examples/first_move" > /dev/null

# Each module has all libraries of its .pc file.
echo 'int main() {}' | logged g++ -x c++ -c - -o "$scratch/empty.o"
for file in "$folder"/jounce-*.pc; do
  module=$(basename "$file" .pc)
  # shellcheck disable=SC2046
  logged g++ "$scratch/empty.o" -o "$scratch/whole" $(PKG_CONFIG_PATH="$folder" pkg-config --libs-only-L "$module") \
    -Wl,--whole-archive "-l$(echo "$module" | tr - _)" -Wl,--no-whole-archive $(words "$module")
done
