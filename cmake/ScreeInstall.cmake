# The program, the libraries with their headers, and find_package(scree).
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY SCREE_LIBRARIES)
install(TARGETS scree RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS ${libraries} EXPORT scree-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(folder core geometry model shapes generators procedurals render formats analysis
        fabrication scenes/reader session)
  install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/scree/${folder}
    FILES_MATCHING PATTERN "*.h")
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/generated/core/version.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/scree/core)
install(DIRECTORY scenes/ DESTINATION ${CMAKE_INSTALL_DATADIR}/scree/scenes
  FILES_MATCHING PATTERN "*.lua")

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/scree)
install(EXPORT scree-targets NAMESPACE scree:: DESTINATION ${package_folder})
configure_package_config_file(cmake/scree-config.cmake.in ${PROJECT_BINARY_DIR}/scree-config.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/scree-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/scree-config.cmake
  ${PROJECT_BINARY_DIR}/scree-config-version.cmake
  cmake/ScreeLibraries.cmake
  DESTINATION ${package_folder})
