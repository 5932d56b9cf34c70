# SPDX-License-Identifier: Apache-2.0
# `find_package(jounce COMPONENTS profiles cam ...)` from an install tree, and a pkg-config file jounce-NAME for each installed
# library.
include(CMakePackageConfigHelpers)

set(JOUNCE_USES_LINES "")
foreach(module ${JOUNCE_INSTALLED})
  list(JOIN JOUNCE_USES_${module} " " used)
  string(APPEND JOUNCE_USES_LINES "set(jounce_uses_${module} ${used})\n")
endforeach()
foreach(module ${JOUNCE_INSTALLED})
  if(TARGET jounce_${module})
    list(TRANSFORM JOUNCE_USES_${module} PREPEND jounce- OUTPUT_VARIABLE required)
    list(JOIN required " " required)
    get_property(libraries GLOBAL PROPERTY JOUNCE_PKGCONFIG_${module})
    list(JOIN libraries " " libraries)
    file(RELATIVE_PATH up ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
    configure_file(cmake/jounce.pc.in ${PROJECT_BINARY_DIR}/pkgconfig/jounce-${module}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/pkgconfig/jounce-${module}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
  endif()
endforeach()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/jounce)
install(EXPORT jounceTargets NAMESPACE jounce:: DESTINATION ${package_dir})
configure_package_config_file(cmake/jounceConfig.cmake.in ${PROJECT_BINARY_DIR}/jounceConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/jounceConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/jounceConfig.cmake ${PROJECT_BINARY_DIR}/jounceConfigVersion.cmake
  cmake/FindLCM.cmake DESTINATION ${package_dir})
