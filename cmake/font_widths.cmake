# roomatlas_font_widths(TARGET NORMAL.ttf BOLD.ttf): the widths of a font's characters become part of the
# target, read when it is built: drawings are the same whatever fonts there are where they are drawn.
# A build for another machine needs CMAKE_CROSSCOMPILING_EMULATOR.
pkg_check_modules(ROOMATLAS_FREETYPE REQUIRED IMPORTED_TARGET freetype2)

function(roomatlas_font_widths target normal bold)
  add_executable(roomatlas_font_widths ${PROJECT_SOURCE_DIR}/cmake/font_widths.cpp)
  target_compile_features(roomatlas_font_widths PRIVATE cxx_std_20)
  target_compile_options(roomatlas_font_widths PRIVATE ${ROOMATLAS_WARNINGS} ${ROOMATLAS_QUICKLY})
  target_link_libraries(roomatlas_font_widths PRIVATE PkgConfig::ROOMATLAS_FREETYPE)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/font_widths.cpp)
  add_custom_command(OUTPUT ${out} COMMAND roomatlas_font_widths ${normal} ${bold} ${out}
    DEPENDS roomatlas_font_widths ${normal} ${bold} VERBATIM)
  set_source_files_properties(${out} PROPERTIES INCLUDE_DIRECTORIES ${PROJECT_SOURCE_DIR}/src/draw
    SKIP_PRECOMPILE_HEADERS ON)
  target_sources(${target} PRIVATE ${out})
endfunction()
