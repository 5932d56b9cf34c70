# SPDX-License-Identifier: Apache-2.0
# jounce_embed(MODULE NAME file ... [NAME file ...] ...): makes a private header of the module, "MODULE_files.hpp". In
# it, jounce::MODULE_files::NAME is a std::string_view with the text of these files, one after another. The assets of a
# page are files so that they are read, checked and compared as files.
function(jounce_embed module)
  # GCC and Clang accept literals that are longer than the 65536 bytes that the standard guarantees.
  set(text "#pragma once\n\n#pragma GCC diagnostic ignored \"-Woverlength-strings\"\n#include <string_view>\n\n")
  string(APPEND text "namespace jounce::${module}_files {\n")
  set(close "")
  foreach(argument ${ARGN})
    if(argument MATCHES "^[a-z_]+$")
      string(APPEND text "${close}\ninline constexpr std::string_view ${argument} =")
      set(close ";\n")
    else()
      file(READ ${argument} content)
      string(APPEND text "\n    R\"FILE(${content})FILE\"")
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${argument})
    endif()
  endforeach()
  string(APPEND text "${close}\n}  // namespace jounce::${module}_files\n")
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/files)
  file(CONFIGURE OUTPUT ${folder}/${module}_files.hpp CONTENT "@text@" @ONLY)
  target_include_directories(jounce_${module} PRIVATE ${folder})
endfunction()
