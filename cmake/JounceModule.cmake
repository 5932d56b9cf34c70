# SPDX-License-Identifier: Apache-2.0
# jounce_declare(NAME module ...): a module and the modules that it includes. CMakeLists.txt declares all of them,
# each after those that it uses. tests/modules/includes.py holds the sources against these lines.
#
# jounce_api(NAME ...): the modules whose headers are installed. The library of another module is installed only if one of
# these modules uses it.
#
# jounce_add_modules(): adds the folders of JOUNCE_MODULES and of all that they use.
#
# jounce_module(NAME SOURCES a.cpp ... [LINKS target ...] [PRIVATE_LINKS target ...] [PRECOMPILE header ...]
#   [PKGCONFIG -llibrary ...] [APART a.cpp ...] [PLANNING | LIGHT])
#
# One library a module, target jounce::NAME. NAME/include holds its public headers, <jounce/NAME/x.hpp>; a header under
# jounce/NAME/detail is for other modules, and is not installed. NAME/src holds sources and private headers,
# "NAME/src/x.hpp", which no other module includes.
#
# PKGCONFIG names the libraries that a program needs beside a static module, for pkg-config.
#
# The sources are compiled in batches, but those in APART (see jounce_unity).
#
# JOUNCE_LEVELS: builds of the types Release and RelWithDebInfo compile a module at -O3. A PLANNING module computes motions
# before they begin, and evaluates none in a cycle: it is compiled at -O2, in six sevenths of the time. A LIGHT module reads,
# writes and prints, or spends its time in the modules and libraries that it calls: -O1, in two thirds. OFF leaves the level to
# CMAKE_CXX_FLAGS and the build type.
option(JOUNCE_LEVELS "Optimize each module at its own level" ${PROJECT_IS_TOP_LEVEL})

set(JOUNCE_WARNINGS -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  list(APPEND JOUNCE_WARNINGS -Wno-restrict)  # false alarms on std::string (GCC bug 105651)
endif()

# GCC otherwise searches for garbage each time that its heap has grown by some 100 MB: a tenth to a fifth of its time.
set(JOUNCE_COMPILER_OPTIONS "")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(JOUNCE_COMPILER_OPTIONS --param=ggc-min-heapsize=524288 --param=ggc-min-expand=100)
endif()

function(jounce_options target)
  target_compile_options(${target} PRIVATE ${JOUNCE_COMPILER_OPTIONS} ${JOUNCE_WARNINGS} $<$<BOOL:${JOUNCE_WERROR}>:-Werror>)
endfunction()

# The options of all modules, so that they can share what is parsed once.
function(jounce_module_options target)
  jounce_options(${target})
  target_compile_options(${target} PRIVATE -fno-math-errno)  # no code asks errno what a root did
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
endfunction()

function(jounce_level target level)
  if(JOUNCE_LEVELS)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release,RelWithDebInfo>:${level}>)
  endif()
endfunction()

# At -O1 GCC takes the storage of an empty std::optional for uninitialised.
function(jounce_light_options target)
  jounce_level(${target} -O1)
  jounce_level(${target} $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endfunction()

jounce_parsed(modules)
jounce_module_options(jounce_parsed_modules)

set(JOUNCE_DECLARED "")
function(jounce_declare name)
  foreach(used ${ARGN})
    if(NOT used IN_LIST JOUNCE_DECLARED)
      message(FATAL_ERROR "jounce_declare: ${name} uses ${used}, which is not declared before it")
    endif()
  endforeach()
  set(JOUNCE_DECLARED ${JOUNCE_DECLARED} ${name} PARENT_SCOPE)
  set(JOUNCE_USES_${name} ${ARGN} PARENT_SCOPE)
endfunction()

# jounce_with_used(RESULT module ...): these modules and all that they use, in the order of their declarations.
function(jounce_with_used result)
  set(wanted ${ARGN})
  set(ordered "")
  set(backwards ${JOUNCE_DECLARED})
  list(REVERSE backwards)
  foreach(module ${backwards})
    if(module IN_LIST wanted)
      list(APPEND wanted ${JOUNCE_USES_${module}})
      list(PREPEND ordered ${module})
    endif()
  endforeach()
  set(${result} ${ordered} PARENT_SCOPE)
endfunction()

function(jounce_api)
  jounce_with_used(installed ${ARGN})
  set(JOUNCE_API ${ARGN} PARENT_SCOPE)
  set(JOUNCE_INSTALLED ${installed} PARENT_SCOPE)
endfunction()

function(jounce_add_modules)
  set(wanted ${JOUNCE_MODULES})
  if(wanted STREQUAL "all")
    set(wanted ${JOUNCE_DECLARED})
  endif()
  foreach(module ${wanted})
    if(NOT module IN_LIST JOUNCE_DECLARED)
      message(FATAL_ERROR "JOUNCE_MODULES = ${module}: must be \"all\" or some of ${JOUNCE_DECLARED}")
    endif()
  endforeach()
  jounce_with_used(wanted ${wanted})
  foreach(module ${wanted})
    add_subdirectory(${module})
  endforeach()
endfunction()

# jounce_built_with(NAME VERSION): a library that `jounce --version` lists.
function(jounce_built_with name version)
  set_property(GLOBAL APPEND PROPERTY JOUNCE_BUILT_WITH "{\"${name}\", \"${version}\"}")
endfunction()

function(jounce_module name)
  cmake_parse_arguments(MODULE "PLANNING;LIGHT" "" "SOURCES;APART;LINKS;PRIVATE_LINKS;PRECOMPILE;PKGCONFIG" ${ARGN})
  set_property(GLOBAL PROPERTY JOUNCE_PKGCONFIG_${name} "${MODULE_PKGCONFIG}")
  if(NOT MODULE_PRECOMPILE)
    set(MODULE_PRECOMPILE REUSE jounce_parsed_modules)
  endif()

  add_library(jounce_${name} ${MODULE_SOURCES})
  add_library(jounce::${name} ALIAS jounce_${name})
  set_target_properties(jounce_${name} PROPERTIES EXPORT_NAME ${name}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  jounce_module_options(jounce_${name})
  if(MODULE_LIGHT)
    jounce_light_options(jounce_${name})
  elseif(MODULE_PLANNING)
    jounce_level(jounce_${name} -O2)
  else()
    jounce_level(jounce_${name} $<$<CONFIG:RelWithDebInfo>:-O3>)  # Release has it
  endif()
  jounce_unity(jounce_${name} ${MODULE_APART})
  if(NOT JOUNCE_UNITY)  # a batch parses these headers as fast as the compiler loads them
    jounce_precompile(jounce_${name} ${MODULE_PRECOMPILE})
  endif()
  target_compile_features(jounce_${name} PUBLIC cxx_std_20)
  target_include_directories(jounce_${name}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR})
  set(used ${JOUNCE_USES_${name}})
  list(TRANSFORM used PREPEND jounce::)
  target_link_libraries(jounce_${name} PUBLIC ${used} ${MODULE_LINKS} PRIVATE ${MODULE_PRIVATE_LINKS})

  if(NOT JOUNCE_INSTALL OR NOT name IN_LIST JOUNCE_INSTALLED)
    return()
  endif()
  install(TARGETS jounce_${name} EXPORT jounceTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  if(name IN_LIST JOUNCE_API)
    install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
      FILES_MATCHING PATTERN "*.hpp" PATTERN "detail" EXCLUDE)
  endif()
endfunction()
