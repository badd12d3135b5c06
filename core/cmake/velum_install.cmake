# Installs the five libraries with their headers, the program, and the files of find_package(velum).
include(CMakePackageConfigHelpers)
set(velum_config_dir "${CMAKE_INSTALL_LIBDIR}/cmake/velum")

set(velum_folders core lbm structure contact ibm)
list(TRANSFORM velum_folders PREPEND velum_ OUTPUT_VARIABLE velum_targets)
install(TARGETS ${velum_targets} EXPORT velumTargets)
install(TARGETS velum)
install(EXPORT velumTargets NAMESPACE velum:: DESTINATION "${velum_config_dir}")
install(DIRECTORY ${velum_folders} DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/velum"
  FILES_MATCHING PATTERN "*.hpp" PATTERN cmake EXCLUDE)

configure_package_config_file(core/cmake/velumConfig.cmake.in
  "${PROJECT_BINARY_DIR}/velumConfig.cmake"
  INSTALL_DESTINATION "${velum_config_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/velumConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/velumConfig.cmake" "${PROJECT_BINARY_DIR}/velumConfigVersion.cmake"
  DESTINATION "${velum_config_dir}")
