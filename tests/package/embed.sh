#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Builds a program that adds Jounce's sources with add_subdirectory, as FetchContent does, and `profiles` of it: no other
# library is looked for, and neither tests nor programs are added.
#   embed.sh JOUNCE_SOURCE_DIR MAIN
set -eu
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cat > "$scratch/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(embedder CXX)
set(JOUNCE_MODULES profiles)
include(FetchContent)
FetchContent_Declare(jounce SOURCE_DIR "$1")
FetchContent_MakeAvailable(jounce)
foreach(target jounce_cam jounce_base jounce_cli test_profiles)
  if(TARGET \${target})
    message(FATAL_ERROR "\${target} is added")
  endif()
endforeach()
add_executable(embedder "$2")
target_link_libraries(embedder PRIVATE jounce::profiles)
END
logged() { "$@" >> "$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }; }
logged cmake -G Ninja -S "$scratch" -B "$scratch/build" -DCMAKE_BUILD_TYPE= -DCMAKE_CXX_FLAGS=-O0 -DJOUNCE_PCH=ON
if grep -iE 'nlopt|sundials|fmt|Eigen|lcm' "$scratch/log"; then exit 1; fi
logged cmake --build "$scratch/build" --target embedder
[ "$("$scratch/build/embedder")" = "1300 ms, at most 50 pulse/ms" ]
