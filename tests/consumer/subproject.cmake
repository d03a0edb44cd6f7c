# Configures tests/consumer/subproject, which checks itself, and sees that the library brings no
# rules of installation:
#   cmake -DROOMATLAS=... -DOUT=... -DGENERATOR=... -DCOMPILER=... -P subproject.cmake
file(REMOVE_RECURSE ${OUT})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/subproject -B ${OUT}/build
                        -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER} -DROOMATLAS=${ROOMATLAS}
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${OUT}/build --prefix ${OUT}/prefix
                COMMAND_ERROR_IS_FATAL ANY)
if(EXISTS ${OUT}/prefix)
  message(FATAL_ERROR "as a part of another project it installed something")
endif()
