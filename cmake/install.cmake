# Installs the rooms as the CMake package `fourpost`, the executable and its data.
include_guard()
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(FOURPOST_DATA_DIR ${CMAKE_INSTALL_DATADIR}/fourpost)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/fourpost)

get_property(rooms GLOBAL PROPERTY fourpost_rooms)
get_property(parts GLOBAL PROPERTY fourpost_parts)
get_property(public_target GLOBAL PROPERTY fourpost_public_target)
list(REMOVE_ITEM rooms ${public_target})
# Static: what links the public one links the rooms behind it, whose headers are not installed.
install(TARGETS ${rooms} ${parts} EXPORT fourpostTargets ARCHIVE COMPONENT development)
install(TARGETS ${public_target} EXPORT fourpostTargets
  ARCHIVE COMPONENT development
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
install(EXPORT fourpostTargets NAMESPACE fourpost:: DESTINATION ${package_dir} COMPONENT development)

configure_package_config_file(cmake/fourpostConfig.cmake.in fourpostConfig.cmake
  INSTALL_DESTINATION ${package_dir} PATH_VARS FOURPOST_DATA_DIR)
# Before 1.0 a minor version may break its users.
write_basic_package_version_file(fourpostConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
    ${CMAKE_CURRENT_BINARY_DIR}/fourpostConfig.cmake
    ${CMAKE_CURRENT_BINARY_DIR}/fourpostConfigVersion.cmake
    ${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake
  DESTINATION ${package_dir} COMPONENT development)

if(TARGET fourpost)
  install(TARGETS fourpost COMPONENT program)
  # The program prints its manual page and what shells complete.
  set(manual_dir ${PROJECT_BINARY_DIR}/manual)
  foreach(part IN ITEMS "fourpost.1:man" "fourpost.bash:completion bash" "_fourpost:completion zsh" "fourpost.fish:completion fish")
    string(REGEX MATCH "^[^:]*" file ${part})
    string(REGEX REPLACE "^[^:]*:" "" words ${part})
    separate_arguments(words)
    add_custom_command(OUTPUT ${manual_dir}/${file}
      COMMAND ${CMAKE_COMMAND} -E make_directory ${manual_dir}
      COMMAND fourpost ${words} > ${manual_dir}/${file}
      DEPENDS fourpost VERBATIM)
    list(APPEND manual_files ${manual_dir}/${file})
  endforeach()
  add_custom_target(fourpost_manual ALL DEPENDS ${manual_files})
  install(FILES ${manual_dir}/fourpost.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
  install(FILES ${manual_dir}/fourpost.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program RENAME fourpost)
  install(FILES ${manual_dir}/_fourpost DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT program)
  install(FILES ${manual_dir}/fourpost.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program)
endif()
# Studies name their vehicle, and vehicles their meshes, by relative paths: the three keep their places.
install(DIRECTORY urdf meshes studies DESTINATION ${FOURPOST_DATA_DIR} COMPONENT program)
# What `fourpost batch` runs.
install(DIRECTORY python/fourpost_batch DESTINATION ${FOURPOST_DATA_DIR}/python COMPONENT program FILES_MATCHING PATTERN "*.py")
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/fourpost RENAME copyright COMPONENT program)

# `cpack --config build/release/CPackConfig.cmake` makes the Debian package of the program.
set(CPACK_PACKAGE_NAME fourpost)
set(CPACK_PACKAGE_CONTACT "The fourpost authors")
set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL program)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME fourpost)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Of `fourpost batch` alone.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS python3-yaml)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS python3-distributed)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
include(CPack)
