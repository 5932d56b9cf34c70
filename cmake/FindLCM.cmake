# SPDX-License-Identifier: Apache-2.0
# Finds LCM (lightweight communications and marshalling) and its type compiler: target LCM::LCM,
# program LCM_GEN. Debian's 1.3.1 brings no CMake files, and its pkg-config file asks for GLib's
# development files, which LCM's headers do not need.
find_path(LCM_INCLUDE_DIR lcm/lcm-cpp.hpp)
find_library(LCM_LIBRARY lcm)
find_program(LCM_GEN lcm-gen)
if(LCM_INCLUDE_DIR)
  set(LCM_VERSION "")
  foreach(part MAJOR MINOR MICRO)
    file(STRINGS ${LCM_INCLUDE_DIR}/lcm/lcm.h line REGEX "^#define LCM_${part}_VERSION ")
    string(REGEX REPLACE "[^0-9]*([0-9]+)$" "\\1" number "${line}")
    list(APPEND LCM_VERSION ${number})
  endforeach()
  list(JOIN LCM_VERSION "." LCM_VERSION)
endif()
mark_as_advanced(LCM_INCLUDE_DIR LCM_LIBRARY LCM_GEN)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LCM REQUIRED_VARS LCM_LIBRARY LCM_INCLUDE_DIR LCM_GEN VERSION_VAR LCM_VERSION)

if(LCM_FOUND AND NOT TARGET LCM::LCM)
  add_library(LCM::LCM UNKNOWN IMPORTED)
  set_target_properties(LCM::LCM PROPERTIES
    IMPORTED_LOCATION ${LCM_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${LCM_INCLUDE_DIR})
endif()

# lcm_types(OUT DIRECTORY PACKAGE FILE ...): C++ types from .lcm files, each of which holds one type
# of that package and its name. OUT gets the headers' paths: add them to the SOURCES of the target
# that includes them, and DIRECTORY to its SYSTEM include folders (they warn). lcm-gen exits with 0
# on types it does not know, so a type is right only where a test pins its hash.
function(lcm_types out directory package)
  set(headers)
  foreach(file ${ARGN})
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    cmake_path(GET file STEM type)
    set(header ${directory}/${package}/${type}.hpp)
    add_custom_command(OUTPUT ${header}
      COMMAND ${LCM_GEN} --cpp --cpp-std=c++11 --cpp-hpath ${directory} ${file}
      DEPENDS ${file} COMMENT "lcm-gen ${type}" VERBATIM)
    list(APPEND headers ${header})
  endforeach()
  set(${out} ${headers} PARENT_SCOPE)
endfunction()
