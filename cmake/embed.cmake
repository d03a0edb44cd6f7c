# Text files as C++ constants.
# As a script: cmake -DOUT=file.cpp -DFILES=a;b -P embed.cmake writes
#   const std::map<std::string, std::string>& roomatlas::drawing::report_assets()
# with each file's content under its name. As an include: roomatlas_embed(TARGET FILES...).

if(CMAKE_SCRIPT_MODE_FILE)
  set(code "#include \"report_assets.hpp\"\n\nnamespace roomatlas::drawing {\n
const std::map<std::string, std::string>& report_assets() {
  static const std::map<std::string, std::string> assets = {\n")
  foreach(file IN LISTS FILES)
    file(READ "${file}" content)
    # Nothing may be fetched: no maps of sources, no pictures of styles.
    string(REGEX REPLACE "//# sourceMappingURL=[^\n]*" "" content "${content}")
    string(REGEX REPLACE "/\\*# sourceMappingURL=[^*]*\\*/" "" content "${content}")
    get_filename_component(name "${file}" NAME)
    string(REPLACE "leaflet.min." "leaflet." name "${name}")
    if(name STREQUAL "leaflet.css")
      string(REGEX REPLACE "url\\([^)]*\\)" "none" content "${content}")
    endif()
    string(APPEND code "      {\"${name}\", R\"asset(${content})asset\"},\n")
  endforeach()
  string(APPEND code "  };\n  return assets;\n}\n\n}  // namespace roomatlas::drawing\n")
  file(WRITE "${OUT}" "${code}")
  return()
endif()

set(ROOMATLAS_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

# roomatlas_embed(TARGET FILES...): the files become part of the target, built anew when one of them
# changes.
function(roomatlas_embed target)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/report_assets.cpp)
  add_custom_command(OUTPUT ${out}
    COMMAND ${CMAKE_COMMAND} -DOUT=${out} "-DFILES=${ARGN}" -P ${ROOMATLAS_EMBED_SCRIPT}
    DEPENDS ${ARGN} ${ROOMATLAS_EMBED_SCRIPT} VERBATIM)
  set_source_files_properties(${out} PROPERTIES COMPILE_OPTIONS -Wno-overlength-strings
    INCLUDE_DIRECTORIES ${PROJECT_SOURCE_DIR}/src/draw)
  target_sources(${target} PRIVATE ${out})
endfunction()
