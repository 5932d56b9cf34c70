# jounce_room(NAME SOURCES a.cpp ... [USES room ...] [LINKS target ...] [PRIVATE_LINKS target ...]
#   [PRECOMPILE header ...] [LIGHT])
#
# One static library a room, target jounce::NAME. A room's headers are seen as <jounce/NAME/x.hpp>
# through an include folder of its own, which holds a link to that one room: so a room sees only the
# rooms it USES, and a wrong include does not build.
#
# A LIGHT room reads, writes and prints. It is compiled at -O1, in three quarters of the time of -O3.
set(JOUNCE_WARNINGS -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  list(APPEND JOUNCE_WARNINGS -Wno-restrict)  # false alarms on std::string (GCC bug 105651)
endif()

function(jounce_options target)
  target_compile_options(${target} PRIVATE ${JOUNCE_WARNINGS} $<$<BOOL:${JOUNCE_WERROR}>:-Werror>)
endfunction()

# What all rooms are compiled with, so that they can share what is parsed once.
function(jounce_room_options target)
  jounce_options(${target})
  target_compile_options(${target} PRIVATE -fno-math-errno)  # nobody asks errno what a root did
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
endfunction()

# At -O1 GCC takes what a std::optional does not hold for uninitialised.
function(jounce_light_options target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>
    $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>)
endfunction()

jounce_parsed(rooms)
jounce_room_options(jounce_parsed_rooms)
jounce_parsed(light)
jounce_room_options(jounce_parsed_light)
jounce_light_options(jounce_parsed_light)

function(jounce_room name)
  cmake_parse_arguments(ROOM "LIGHT" "" "SOURCES;USES;LINKS;PRIVATE_LINKS;PRECOMPILE" ${ARGN})
  if(NOT ROOM_PRECOMPILE AND ROOM_LIGHT)
    set(ROOM_PRECOMPILE REUSE jounce_parsed_light)
  elseif(NOT ROOM_PRECOMPILE)
    set(ROOM_PRECOMPILE REUSE jounce_parsed_rooms)
  endif()
  set(view ${PROJECT_BINARY_DIR}/rooms/${name})
  file(MAKE_DIRECTORY ${view}/jounce)
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${view}/jounce/${name} SYMBOLIC)

  add_library(jounce_${name} STATIC ${ROOM_SOURCES})
  add_library(jounce::${name} ALIAS jounce_${name})
  set_target_properties(jounce_${name} PROPERTIES EXPORT_NAME ${name})
  jounce_room_options(jounce_${name})
  if(ROOM_LIGHT)
    jounce_light_options(jounce_${name})
  endif()
  jounce_precompile(jounce_${name} ${ROOM_PRECOMPILE})
  target_compile_features(jounce_${name} PUBLIC cxx_std_20)
  target_include_directories(jounce_${name} PUBLIC
    $<BUILD_INTERFACE:${view}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  list(TRANSFORM ROOM_USES PREPEND jounce::)
  target_link_libraries(jounce_${name} PUBLIC ${ROOM_USES} ${ROOM_LINKS} PRIVATE ${ROOM_PRIVATE_LINKS})

  install(TARGETS jounce_${name} EXPORT jounceTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY ./ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/jounce/${name}
    FILES_MATCHING PATTERN "*.hpp" PATTERN "detail" EXCLUDE)
endfunction()
