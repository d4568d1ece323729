# What `cmake --install` brings: the program (its own folder says so), the libraries, their headers, the samples and
# the pages, and a package through which find_package(lancer) gives lancer::session, lancer::tracer and what they use.
include(CMakePackageConfigHelpers)

set(lancer_package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/lancer)

get_property(lancer_rooms GLOBAL PROPERTY LANCER_ROOMS)
install(TARGETS ${lancer_rooms} EXPORT lancerTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT lancerTargets NAMESPACE lancer:: DESTINATION ${lancer_package_folder})

# The grammar's headers stay at home: nobody but the session needs them, and they would need PEGTL.
foreach(room base scene image lang tracer session)
  install(DIRECTORY src/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lancer FILES_MATCHING PATTERN "*.hpp")
endforeach()

configure_package_config_file(
  cmake/lancerConfig.cmake.in ${PROJECT_BINARY_DIR}/lancerConfig.cmake INSTALL_DESTINATION ${lancer_package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/lancerConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/lancerConfig.cmake ${PROJECT_BINARY_DIR}/lancerConfigVersion.cmake
  DESTINATION ${lancer_package_folder})

install(DIRECTORY samples/ DESTINATION ${CMAKE_INSTALL_DATADIR}/lancer/samples FILES_MATCHING PATTERN "*.scn")
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
