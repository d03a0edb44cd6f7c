# What holds only where this is the project itself and not a part of another: build type, compiler
# cache, linker, sanitizers.
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_CXX_EXTENSIONS OFF)

find_program(CCACHE ccache)
if(CCACHE)
  # What ccache must be told of precompiled headers (its manual, "Precompiled headers").
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${CCACHE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND ROOMATLAS_PRECOMPILED_HEADERS)
    add_compile_options(-fpch-preprocess)
  elseif(CMAKE_CXX_COMPILER_ID STREQUAL Clang AND ROOMATLAS_PRECOMPILED_HEADERS)
    add_compile_options("SHELL:-Xclang -fno-pch-timestamp")
  endif()
endif()

# The faster linker of those that are there.
include(CheckLinkerFlag)
foreach(linker mold lld)
  check_linker_flag(CXX -fuse-ld=${linker} ROOMATLAS_HAS_${linker})
  if(ROOMATLAS_HAS_${linker})
    add_link_options(-fuse-ld=${linker})
    break()
  endif()
endforeach()

if(ROOMATLAS_SANITIZER STREQUAL address)
  # What is undefined ends the program as a wrong access does; both say where.
  set(sanitize -fsanitize=address,undefined -fno-sanitize-recover=undefined)
  # Else Eigen pads what it allocates where it sees this sanitizer, and Ceres' library, which does not,
  # frees it as it is.
  add_compile_definitions(EIGEN_MALLOC_ALREADY_ALIGNED=1)
elseif(ROOMATLAS_SANITIZER STREQUAL thread)
  set(sanitize -fsanitize=thread)
elseif(ROOMATLAS_SANITIZER)
  message(FATAL_ERROR "ROOMATLAS_SANITIZER is '${ROOMATLAS_SANITIZER}': address or thread")
endif()
if(ROOMATLAS_SANITIZER)
  add_compile_options(${sanitize} -fno-omit-frame-pointer)
  # AddressSanitizer stands between a program and dlopen: only the older kind of run path, which holds
  # for all that is loaded, is looked at then.
  add_link_options(${sanitize} LINKER:--disable-new-dtags)
endif()
if(ROOMATLAS_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    message(FATAL_ERROR "ROOMATLAS_FUZZ needs clang, whose libFuzzer it uses: cmake --preset fuzz")
  endif()
  add_compile_options(-fsanitize=fuzzer-no-link
                      -fsanitize-coverage-allowlist=${PROJECT_SOURCE_DIR}/tests/fuzz/guided.txt)
endif()
