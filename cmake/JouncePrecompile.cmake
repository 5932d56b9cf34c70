# SPDX-License-Identifier: Apache-2.0
# jounce_precompile(TARGET header ...): parses them, and what is common of the standard library, once
# for all files of TARGET. jounce_precompile(TARGET REUSE other): as parsed for `other`, where both
# have the same flags. jounce_parsed(NAME header ...): a target jounce_parsed_NAME to reuse.
#
# GCC compiles a file at the level of optimization of its precompiled header, without a warning: a file at -O1 that reuses a
# header of -O3 takes as long as at -O3.
#
# A precompiled header comes before a file's own first line, so it hides what that file forgot to
# include. The presets tidy and ccache therefore compile each file alone; ccache gains nothing from a precompiled header. A
# project that adds Jounce with add_subdirectory gets neither precompiled headers nor batches, unless it sets the options.
option(JOUNCE_PCH "Precompile the headers that many files include" ${PROJECT_IS_TOP_LEVEL})

# jounce_unity(TARGET [file ...]): joins the sources of TARGET, but the given ones, into batches of equal size, each compiled as
# one file. All sources of a batch share what they instantiate, so they compile in a third of the time. Names of unnamed
# namespaces are then unique in a target.
option(JOUNCE_UNITY "Compile many sources at a time" ${PROJECT_IS_TOP_LEVEL})

set(JOUNCE_BATCH 35)  # sources, at most

function(jounce_unity target)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "[.]cpp$")
  list(LENGTH sources all)
  list(LENGTH ARGN apart)
  math(EXPR joined "${all} - ${apart}")
  math(EXPR batches "(${joined} - 1) / ${JOUNCE_BATCH} + 1")
  math(EXPR size "(${joined} + ${batches} - 1) / ${batches}")
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${JOUNCE_UNITY} UNITY_BUILD_BATCH_SIZE ${size})
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  if(JOUNCE_UNITY)
    # A batch puts the unnamed namespaces of its files in one scope, so a local name can shadow a name of another file.
    # The presets dev and tidy compile each file alone with -Wshadow.
    target_compile_options(${target} PRIVATE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>)
  endif()
endfunction()

function(jounce_precompile target)
  if(NOT JOUNCE_PCH)
    return()
  endif()
  cmake_parse_arguments(PCH "" "REUSE" "" ${ARGN})
  if(PCH_REUSE)
    target_precompile_headers(${target} REUSE_FROM ${PCH_REUSE})
  else()
    target_precompile_headers(${target} PRIVATE <algorithm> <array> <cmath> <functional> <limits> <map>
      <memory> <numbers> <optional> <span> <string> <utility> <variant> <vector> ${ARGN})
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # More false alarms on std::string (GCC bug 105651) where its header is precompiled.
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow
      -Wno-stringop-overread)
  endif()
endfunction()

function(jounce_parsed name)
  set(nothing ${CMAKE_CURRENT_BINARY_DIR}/parsed_${name}.cpp)
  file(CONFIGURE OUTPUT ${nothing} CONTENT "")
  add_library(jounce_parsed_${name} OBJECT EXCLUDE_FROM_ALL ${nothing})
  jounce_precompile(jounce_parsed_${name} ${ARGN})
endfunction()
