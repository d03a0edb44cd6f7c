# Every public header compiles alone, and with Eigen alone: one translation unit a header. It
# stands there twice, so that a missing include guard shows too.
file(GLOB_RECURSE public_headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/include
     ${PROJECT_SOURCE_DIR}/include/roomatlas/*.hpp)

set(header_check_sources)
foreach(header IN LISTS public_headers)
  string(REGEX REPLACE "[/.]" "_" name ${header})
  set(source ${PROJECT_BINARY_DIR}/header_check/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "#include \"${header}\"\n#include \"${header}\"\n" @ONLY)
  list(APPEND header_check_sources ${source})
endforeach()

add_library(header_check OBJECT ${header_check_sources})
target_compile_features(header_check PRIVATE cxx_std_20)
target_include_directories(header_check PRIVATE ${PROJECT_SOURCE_DIR}/include)
target_link_libraries(header_check PRIVATE Eigen3::Eigen)
target_compile_options(header_check PRIVATE ${ROOMATLAS_WARNINGS} -O0)
