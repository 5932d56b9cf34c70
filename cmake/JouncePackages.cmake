# SPDX-License-Identifier: Apache-2.0
# The files beside the program (manual pages, completion of the shells, pages, examples), and the Debian packages: one for
# each component of the installation.
#
#   program  jounce          the program and the files beside it
#   mpi      jounce-mpi      `jounce sweep` under mpirun; only if MPI was found
#   dev      libjounce-dev   headers, static libraries, files for CMake and pkg-config
#   python   python3-jounce  the Python module; only if the target _jounce exists
#
# cpack makes the packages from a build tree with the prefix /usr; scripts/package makes such a tree.
set(JOUNCE_MAINTAINER "Jounce maintainers <maintainers@jounce.example>" CACHE STRING
  "Maintainer of the Debian packages")
set(JOUNCE_HOMEPAGE "" CACHE STRING "Homepage of the Debian packages")

find_program(GZIP gzip)
if(NOT GZIP OR NOT TARGET jounce_cli OR BUILD_SHARED_LIBS)
  return()  # packages contain static libraries (0101)
endif()
if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
  message(STATUS "jounce: no manual pages and no packages: the program writes its manual, and does not run on this machine")
  return()
endif()
set(package_files ${PROJECT_BINARY_DIR}/packages)
set(doc ${CMAKE_INSTALL_DATAROOTDIR}/doc)

# Changelogs. The date of Debian's is that of the sources: SOURCE_DATE_EPOCH, if it is set.
string(TIMESTAMP JOUNCE_PACKAGE_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(cmake/debian/changelog.in ${package_files}/changelog @ONLY)
add_custom_command(OUTPUT ${package_files}/changelog.gz ${package_files}/CHANGELOG.md.gz
  COMMAND ${GZIP} -9nc changelog > changelog.gz
  COMMAND ${GZIP} -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md > CHANGELOG.md.gz
  DEPENDS ${package_files}/changelog CHANGELOG.md WORKING_DIRECTORY ${package_files} VERBATIM)

# The program writes its manual pages. Their number depends on its verbs, so a folder of them is installed.
set(manual ${package_files}/man1)
add_custom_command(OUTPUT ${package_files}/man1.made
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${manual}
  COMMAND ${CMAKE_COMMAND} -E make_directory ${manual}
  COMMAND jounce_cli man ${manual}
  COMMAND ${GZIP} -9n -r ${manual}
  COMMAND ${CMAKE_COMMAND} -E touch ${package_files}/man1.made
  DEPENDS jounce_cli COMMENT "manual pages" VERBATIM)
add_custom_target(jounce_package_files ALL
  DEPENDS ${package_files}/changelog.gz ${package_files}/CHANGELOG.md.gz ${package_files}/man1.made)

set(zsh site-functions)
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(zsh vendor-completions)
endif()
install(DIRECTORY ${manual} DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT program)
install(FILES about/completion/jounce.bash COMPONENT program
  DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/bash-completion/completions RENAME jounce)
install(FILES about/completion/jounce.zsh COMPONENT program
  DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/zsh/${zsh} RENAME _jounce)
install(FILES about/completion/jounce.fish COMPONENT program
  DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/fish/vendor_completions.d)
install(FILES README.md ${package_files}/CHANGELOG.md.gz COMPONENT program DESTINATION ${doc}/jounce)
install(DIRECTORY docs COMPONENT program DESTINATION ${doc}/jounce)
install(DIRECTORY examples COMPONENT program DESTINATION ${doc}/jounce USE_SOURCE_PERMISSIONS PATTERN library EXCLUDE)
install(DIRECTORY examples/library/ COMPONENT dev DESTINATION ${doc}/libjounce-dev/examples)

# jounce_package(COMPONENT PACKAGE SECTION section DESCRIPTION text [DEPENDS package ...] [RECOMMENDS package ...]
#   [SUGGESTS package ...]): the package of a component. The first line of its description is the summary. dpkg-shlibdeps adds
# the packages of the shared libraries. Each package contains its changelog and its copyright.
macro(jounce_package component package)
  cmake_parse_arguments(PACKAGE "" "SECTION;DESCRIPTION" "DEPENDS;RECOMMENDS;SUGGESTS" ${ARGN})
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${PACKAGE_SECTION})
  set(CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_STRICT_PERMISSION ON)
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${PACKAGE_DESCRIPTION}")
  foreach(relation DEPENDS RECOMMENDS SUGGESTS)
    list(JOIN PACKAGE_${relation} ", " CPACK_DEBIAN_${upper}_PACKAGE_${relation})
  endforeach()
  install(FILES ${package_files}/changelog.gz cmake/debian/copyright DESTINATION ${doc}/${package} COMPONENT ${component})
endmacro()

set(CPACK_COMPONENTS_ALL "")
jounce_package(program jounce SECTION science RECOMMENDS librsvg2-bin SUGGESTS git jounce-mpi DESCRIPTION
"toolkit for motion tables and electronic cams
Jounce reads the description of a motion from a text file. It designs the
motion, checks it exactly against limits of velocity, acceleration and jerk,
optimizes it, verifies it by integration, and plays it on an axis.

The command jounce also checks all motions of a repository in continuous
integration, and converts tables between the formats of controllers.")
if(TARGET jounce_mpi)
  jounce_package(mpi jounce-mpi SECTION science DEPENDS "jounce (= ${PROJECT_VERSION})" DESCRIPTION
"toolkit for motion tables and electronic cams - sweeps under MPI
With this module, the command jounce sweep distributes its cases over the
processes of mpirun.")
endif()
jounce_package(dev libjounce-dev SECTION libdevel
  DEPENDS libfmt-dev libnlopt-cxx-dev libpugixml-dev libsodium-dev libdeflate-dev libssl-dev libsundials-dev libzip-dev
    libtomlplusplus-dev libudunits2-dev libyaml-cpp-dev liblcm-bin liblcm-dev nlohmann-json3-dev DESCRIPTION
"toolkit for motion tables and electronic cams - development files
This package contains the headers and the static libraries of Jounce, and
the files with which CMake and pkg-config find them. The library profiles
(curves, moves, exact extrema) needs no other library.")
if(TARGET _jounce)
  jounce_package(python python3-jounce SECTION python
    DEPENDS "python3 (>= 3.11)" "python3 (<< 3.12)" python3-numpy DESCRIPTION
"toolkit for motion tables and electronic cams - Python module
With this package, a Python program reads and designs motions, evaluates
them on NumPy arrays, checks their limits, and optimizes them.")
  set(debian ${PROJECT_SOURCE_DIR}/cmake/debian/python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${debian}/postinst ${debian}/prerm)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_PACKAGE_NAME jounce)
set(CPACK_PACKAGE_CONTACT ${JOUNCE_MAINTAINER})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # would begin the description of each package
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_DEV_PACKAGE_SHLIBDEPS OFF)  # static libraries
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE ${JOUNCE_HOMEPAGE})
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
include(CPack)
