# What `cmake --install` leaves: the libraries, the public headers, the command, and the two ways to
# find them, find_package(batten) and pkg-config.
include(CMakePackageConfigHelpers)
set(batten_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/batten)

set(batten_installed batten_static)
if(TARGET batten)
    list(APPEND batten_installed batten)
endif()
install(TARGETS ${batten_installed} EXPORT batten_targets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/batten DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN *.hpp)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(EXPORT batten_targets NAMESPACE batten:: FILE batten-targets.cmake
        DESTINATION ${batten_package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/batten-config.cmake.in
                              ${PROJECT_BINARY_DIR}/batten-config.cmake
                              INSTALL_DESTINATION ${batten_package_dir}
                              NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/batten-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/batten-config.cmake
              ${PROJECT_BINARY_DIR}/batten-config-version.cmake
        DESTINATION ${batten_package_dir})

# Relative to the .pc file itself, so that the tree can be moved.
file(RELATIVE_PATH batten_pc_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(${PROJECT_SOURCE_DIR}/cmake/batten.pc.in ${PROJECT_BINARY_DIR}/batten.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/batten.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
