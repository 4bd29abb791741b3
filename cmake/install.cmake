# Installs the rooms as the CMake package `fourpost`, the executable and its data.
include_guard()
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(FOURPOST_DATA_DIR ${CMAKE_INSTALL_DATADIR}/fourpost)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/fourpost)

install(TARGETS fourpost_analysis fourpost_vehicles fourpost_identify EXPORT fourpostTargets
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fourpost)
install(EXPORT fourpostTargets NAMESPACE fourpost:: DESTINATION ${package_dir})

configure_package_config_file(cmake/fourpostConfig.cmake.in fourpostConfig.cmake
  INSTALL_DESTINATION ${package_dir} PATH_VARS FOURPOST_DATA_DIR)
# Before 1.0 a minor version may break its users.
write_basic_package_version_file(fourpostConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
    ${CMAKE_CURRENT_BINARY_DIR}/fourpostConfig.cmake
    ${CMAKE_CURRENT_BINARY_DIR}/fourpostConfigVersion.cmake
    ${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake
  DESTINATION ${package_dir})

if(TARGET fourpost)
  install(TARGETS fourpost)
endif()
# Studies name their vehicle, and vehicles their meshes, by relative paths: the three keep their places.
install(DIRECTORY urdf meshes studies DESTINATION ${FOURPOST_DATA_DIR})
