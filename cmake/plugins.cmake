# Where plug-ins are (plugins/), built and installed. The dynamic linker looks for them in the run path
# of who has the library in it.
if(ROOMATLAS_INSTALL)
  include(GNUInstallDirs)
endif()
add_custom_target(roomatlas_plugins)
set(ROOMATLAS_PLUGINS_BUILT ${PROJECT_BINARY_DIR}/lib/roomatlas)
set(ROOMATLAS_PLUGINS_INSTALLED ${CMAKE_INSTALL_LIBDIR}/roomatlas)

# roomatlas_finds_plugins(TARGET FOLDER): a program or module of ours finds them where it is built, and
# where it is installed, in the FOLDER below the prefix.
function(roomatlas_finds_plugins target folder)
  add_dependencies(${target} roomatlas_plugins)
  file(RELATIVE_PATH up ${CMAKE_CURRENT_BINARY_DIR} ${ROOMATLAS_PLUGINS_BUILT})
  set_target_properties(${target} PROPERTIES BUILD_RPATH $ORIGIN/${up})
  if(ROOMATLAS_PACKAGES)  # whose place is known: $ORIGIN needs a mounted /proc, which a chroot may lack
    set_target_properties(${target} PROPERTIES
      INSTALL_RPATH ${CMAKE_INSTALL_PREFIX}/${ROOMATLAS_PLUGINS_INSTALLED})
  elseif(ROOMATLAS_INSTALL)
    file(RELATIVE_PATH up /${folder} /${ROOMATLAS_PLUGINS_INSTALLED})
    set_target_properties(${target} PROPERTIES INSTALL_RPATH $ORIGIN/${up})
  endif()
endfunction()
