# Manual pages and completions, written by the program that is installed:
#   cmake -DPROGRAM=... -DPREFIX=... -DMAN=... -DDATA=... -DCOMMANDS=ON -P install_text.cmake
# COMMANDS=OFF: of a program without commands, which has one page.
function(write_text out)
  get_filename_component(folder ${out} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE ${out} COMMAND_ERROR_IS_FATAL ANY)
  message(STATUS "Installing: ${out}")
endfunction()

get_filename_component(name ${PROGRAM} NAME)
set(page ${PREFIX}/${MAN}/man1/${name}.1)
if(COMMANDS)
  execute_process(COMMAND ${PROGRAM} man -o ${PREFIX}/${MAN}/man1 COMMAND_ERROR_IS_FATAL ANY)
  message(STATUS "Installing: ${page}, and a page a command")
  write_text(${PREFIX}/${DATA}/bash-completion/completions/${name} completion bash)
  write_text(${PREFIX}/${DATA}/zsh/vendor-completions/_${name} completion zsh)
  write_text(${PREFIX}/${DATA}/fish/vendor_completions.d/${name}.fish completion fish)
else()
  write_text(${page} --man)
endif()
if(GZIP)  # as packages have them
  file(GLOB pages ${PREFIX}/${MAN}/man1/${name}*.1)
  execute_process(COMMAND gzip -9nf ${pages} COMMAND_ERROR_IS_FATAL ANY)
endif()
