# Installs a build into a folder of its own, then configures, builds and runs tests/consumer with
# what is there and nothing else:
#   cmake -DBUILD=... -DOUT=... -DGENERATOR=... -DCOMPILER=... -P installed.cmake
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${OUT})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${OUT}/prefix)

# What is installed says nothing of where it was built.
file(STRINGS ${BUILD}/CMakeCache.txt source REGEX "^CMAKE_HOME_DIRECTORY:")
string(REGEX REPLACE "^[^=]*=" "" source "${source}")
file(GLOB_RECURSE files ${OUT}/prefix/*.cmake ${OUT}/prefix/*.hpp)
foreach(file IN LISTS files)
  file(READ ${file} text)
  string(FIND "${text}" "${source}" place)
  if(NOT place EQUAL -1)
    message(FATAL_ERROR "${file} names ${source}")
  endif()
endforeach()

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${OUT}/build -G ${GENERATOR}
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_PREFIX_PATH=${OUT}/prefix)
run(${CMAKE_COMMAND} --build ${OUT}/build)

execute_process(COMMAND ${OUT}/build/consumer WORKING_DIRECTORY ${OUT}
                OUTPUT_VARIABLE answer COMMAND_ERROR_IS_FATAL ANY)
if(NOT answer STREQUAL "12 m2, 2 m\n")
  message(FATAL_ERROR "the consumer says ${answer}")
endif()
run(${OUT}/prefix/bin/roomatlas --version)
foreach(text share/man/man1/roomatlas.1 share/man/man1/roomatlas-build.1
             share/bash-completion/completions/roomatlas share/zsh/vendor-completions/_roomatlas
             share/fish/vendor_completions.d/roomatlas.fish
             share/roomatlas/worlds/two_rooms.geojson share/roomatlas/package.xml)
  if(NOT EXISTS ${OUT}/prefix/${text})
    message(FATAL_ERROR "${text} is not installed")
  endif()
endforeach()
