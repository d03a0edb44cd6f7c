# What `cmake --install` puts where, so that another project finds it with find_package(roomatlas). Each
# component is a package (cmake/package.cmake); plug-ins and Python say theirs themselves.
include(CMakePackageConfigHelpers)

# roomatlas_install_text(PROGRAM COMPONENT [COMMANDS]): its manual page, and where it has commands a page
# for each and completions. Where the program cannot run here (built for another machine), none.
function(roomatlas_install_text program component)
  if(CMAKE_CROSSCOMPILING)
    return()
  endif()
  cmake_parse_arguments(ARG "COMMANDS" "" "" ${ARGN})
  install(CODE "
    execute_process(COMMAND \"${CMAKE_COMMAND}\" \"-DPROGRAM=$<TARGET_FILE:${program}>\"
      \"-DPREFIX=\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}\" -DMAN=${CMAKE_INSTALL_MANDIR}
      -DDATA=${CMAKE_INSTALL_DATADIR} -DCOMMANDS=${ARG_COMMANDS} -DGZIP=${ROOMATLAS_PACKAGES}
      -P \"${PROJECT_SOURCE_DIR}/cmake/install_text.cmake\"
      COMMAND_ERROR_IS_FATAL ANY)" COMPONENT ${component})
endfunction()

install(TARGETS roomatlas_library EXPORT roomatlas_targets COMPONENT dev)
install(DIRECTORY include/roomatlas TYPE INCLUDE COMPONENT dev FILES_MATCHING PATTERN *.hpp)
set(installed roomatlas_library)
if(ROOMATLAS_PROGRAM)
  install(TARGETS roomatlas COMPONENT program)
  file(GLOB worlds CONFIGURE_DEPENDS data/worlds/*.geojson)  # to try it with
  install(FILES ${worlds} DESTINATION ${CMAKE_INSTALL_DATADIR}/roomatlas/worlds COMPONENT program)
  list(APPEND installed roomatlas)
  roomatlas_install_text(roomatlas program COMMANDS)
  if(TARGET roomatlas-fleet)
    install(TARGETS roomatlas-fleet COMPONENT fleet)
    roomatlas_install_text(roomatlas-fleet fleet)
    list(APPEND installed roomatlas-fleet)
  endif()
endif()
if(TARGET roomatlas_python)
  list(APPEND installed roomatlas_python)
endif()
add_custom_target(installed DEPENDS ${installed})  # what must be built to be installed

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/roomatlas)
install(EXPORT roomatlas_targets NAMESPACE roomatlas:: DESTINATION ${package}
        FILE roomatlasTargets.cmake COMPONENT dev)
configure_package_config_file(cmake/roomatlasConfig.cmake.in roomatlasConfig.cmake
  INSTALL_DESTINATION ${package} NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(roomatlasConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/roomatlasConfig.cmake
              ${PROJECT_BINARY_DIR}/roomatlasConfigVersion.cmake DESTINATION ${package} COMPONENT dev)
# A workspace of ROS looks for it there (REP 136).
install(FILES package.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/roomatlas COMPONENT dev)

if(ROOMATLAS_PACKAGES)
  include(cmake/package.cmake)
else()
  install(FILES LICENSE TYPE DOC)  # packages say where Debian keeps it
endif()
