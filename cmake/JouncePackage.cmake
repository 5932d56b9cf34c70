# `find_package(jounce)` from an install tree: jounce::profiles, jounce::cam, ...
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/jounce)
install(EXPORT jounceTargets NAMESPACE jounce:: DESTINATION ${package_dir})
configure_package_config_file(cmake/jounceConfig.cmake.in ${PROJECT_BINARY_DIR}/jounceConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/jounceConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/jounceConfig.cmake ${PROJECT_BINARY_DIR}/jounceConfigVersion.cmake
  cmake/FindLCM.cmake DESTINATION ${package_dir})
