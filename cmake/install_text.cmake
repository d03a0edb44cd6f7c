# Manual pages and completions, written by the program that is installed:
#   cmake -DPROGRAM=... -DPREFIX=... -DMAN=... -DDATA=... -P install_text.cmake
#   cmake -DFLEET=...   -DPREFIX=... -DMAN=...            -P install_text.cmake
function(write_text out)
  get_filename_component(folder ${out} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${PROGRAM}${FLEET} ${ARGN} OUTPUT_FILE ${out} COMMAND_ERROR_IS_FATAL ANY)
  message(STATUS "Installing: ${out}")
endfunction()

if(FLEET)
  write_text(${PREFIX}/${MAN}/man1/roomatlas-fleet.1 --man)
  if(GZIP)
    execute_process(COMMAND gzip -9nf ${PREFIX}/${MAN}/man1/roomatlas-fleet.1 COMMAND_ERROR_IS_FATAL ANY)
  endif()
  return()
endif()

execute_process(COMMAND ${PROGRAM} man -o ${PREFIX}/${MAN}/man1 COMMAND_ERROR_IS_FATAL ANY)
if(GZIP)  # as packages have them
  file(GLOB pages ${PREFIX}/${MAN}/man1/roomatlas*.1)
  execute_process(COMMAND gzip -9nf ${pages} COMMAND_ERROR_IS_FATAL ANY)
endif()
message(STATUS "Installing: ${PREFIX}/${MAN}/man1/roomatlas.1, and a page a command")
write_text(${PREFIX}/${DATA}/bash-completion/completions/roomatlas completion bash)
write_text(${PREFIX}/${DATA}/zsh/vendor-completions/_roomatlas completion zsh)
write_text(${PREFIX}/${DATA}/fish/vendor_completions.d/roomatlas.fish completion fish)
