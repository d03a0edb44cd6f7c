# The library is one, made of modules; tests are one program a module. The table of modules, and who
# may include whom, is in docs/architecture.md and is checked by tests/architecture.

# -Wno-restrict: g++ 12 warns falsely on "text" + std::string (its bug 105651). With precompiled
# headers the same falsehoods come under two more names, since its marks of system headers are lost.
set(ROOMATLAS_WARNINGS -Wall -Wextra -Wconversion -Wshadow -Wpedantic)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  list(APPEND ROOMATLAS_WARNINGS -Wno-restrict)
endif()
if(ROOMATLAS_PRECOMPILED_HEADERS AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  list(APPEND ROOMATLAS_WARNINGS -Wno-stringop-overflow -Wno-array-bounds)
endif()
if(ROOMATLAS_TOGETHER AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  list(APPEND ROOMATLAS_WARNINGS -Wno-subobject-linkage)  # it takes sources that are included for headers
endif()
if(ROOMATLAS_WERROR)
  list(APPEND ROOMATLAS_WARNINGS -Werror)
endif()

# For what does no work of its own: commands and tests. Half the compile time.
set(ROOMATLAS_QUICKLY $<$<CONFIG:Release>:-O1>)

# roomatlas_precompile(TARGET HEADER...): headers that nearly every file reads, parsed once.
function(roomatlas_precompile target)
  if(ROOMATLAS_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# roomatlas_precompile_as(TARGET OTHER): the headers that OTHER has parsed already.
function(roomatlas_precompile_as target other)
  if(ROOMATLAS_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${other})
  endif()
endfunction()

# roomatlas_compile_together(TARGET): the sources of a folder are compiled up to eight at a time: what
# they all include is read once. Two of a folder therefore give no two things of
# their own one name.
function(roomatlas_compile_together target)
  if(NOT ROOMATLAS_TOGETHER)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  set(folders)
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    list(APPEND folders ${folder})
    list(APPEND "of ${folder}" ${source})
  endforeach()
  list(REMOVE_DUPLICATES folders)
  foreach(folder IN LISTS folders)
    list(LENGTH "of ${folder}" count)
    math(EXPR batches "(${count} + 7) / 8")
    file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR} ${folder})
    string(REPLACE / _ name ${name})
    set(index 0)
    foreach(source IN LISTS "of ${folder}")
      math(EXPR batch "${index} * ${batches} / ${count}")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${name}_${batch})
      math(EXPR index "${index} + 1")
    endforeach()
  endforeach()
endfunction()

# roomatlas_program(NAME SOURCE...): a program of ours on top of the library.
function(roomatlas_program name)
  add_executable(${name} ${ARGN})
  target_compile_options(${name} PRIVATE ${ROOMATLAS_WARNINGS})
  target_link_libraries(${name} PRIVATE roomatlas::roomatlas)
  roomatlas_finds_plugins(${name} ${CMAKE_INSTALL_BINDIR})
endfunction()

# roomatlas_test(NAME [LIBRARIES target...] [TOGETHER suite...]): every .cpp below tests/NAME in one
# program. Tests run one by one, but those of a suite TOGETHER, whose missions are mapped once for
# all; since these take longest, they begin first.
function(roomatlas_test name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "LIBRARIES;TOGETHER")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${name}/*.cpp)
  if(NOT sources)
    message(FATAL_ERROR "no tests below tests/${name}")
  endif()
  set(target test_${name})
  roomatlas_program(${target} ${sources})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  if(IS_DIRECTORY ${PROJECT_SOURCE_DIR}/src/${name})
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src/${name})
  endif()
  target_compile_options(${target} PRIVATE ${ROOMATLAS_QUICKLY})
  target_compile_definitions(${target} PRIVATE ROOMATLAS_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(${target} PRIVATE ${ARG_LIBRARIES} GTest::gmock GTest::gtest_main)
  roomatlas_precompile_as(${target} roomatlas_test_headers)
  roomatlas_compile_together(${target})
  foreach(suite ${ARG_TOGETHER})
    add_test(NAME "${name}: ${suite}" COMMAND ${target} --gtest_filter=${suite}.*)
    set_tests_properties("${name}: ${suite}" PROPERTIES COST 100
      FAIL_REGULAR_EXPRESSION "Running 0 tests")  # there is no such suite any more
  endforeach()
  list(TRANSFORM ARG_TOGETHER APPEND ".*")
  list(JOIN ARG_TOGETHER ":" together)
  gtest_discover_tests(${target} TEST_PREFIX "${name}: " DISCOVERY_TIMEOUT 60
    TEST_FILTER "*:-${together}")
endfunction()
