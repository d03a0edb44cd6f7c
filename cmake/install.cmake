# What `cmake --install` puts where, so that another project finds it with find_package(roomatlas).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS roomatlas_library EXPORT roomatlas_targets)
install(DIRECTORY include/roomatlas TYPE INCLUDE FILES_MATCHING PATTERN *.hpp)
if(ROOMATLAS_PROGRAM)
  install(TARGETS roomatlas)
  # Where the program cannot run here (built for another machine), it is installed without them.
  if(NOT CMAKE_CROSSCOMPILING)
    install(CODE "
      execute_process(COMMAND \"${CMAKE_COMMAND}\" \"-DPROGRAM=$<TARGET_FILE:roomatlas>\"
        \"-DPREFIX=\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}\" -DMAN=${CMAKE_INSTALL_MANDIR}
        -DDATA=${CMAKE_INSTALL_DATADIR} -P \"${PROJECT_SOURCE_DIR}/cmake/install_text.cmake\"
        COMMAND_ERROR_IS_FATAL ANY)")
  endif()
  if(TARGET roomatlas-fleet)
    install(TARGETS roomatlas-fleet)
  endif()
endif()
install(FILES LICENSE TYPE DOC)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/roomatlas)
install(EXPORT roomatlas_targets NAMESPACE roomatlas:: DESTINATION ${package}
        FILE roomatlasTargets.cmake)
set(uses_gdal OFF)
if(TARGET GDAL::GDAL)
  set(uses_gdal ON)
endif()
configure_package_config_file(cmake/roomatlasConfig.cmake.in roomatlasConfig.cmake
  INSTALL_DESTINATION ${package} NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(roomatlasConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/roomatlasConfig.cmake
              ${PROJECT_BINARY_DIR}/roomatlasConfigVersion.cmake DESTINATION ${package})
