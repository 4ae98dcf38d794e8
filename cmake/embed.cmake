# Files that become part of a program: `hsr_embed(target files...)` makes a source of them, again whenever one of them changes, and
# adds it to the target. It defines std::string_view page_text(std::string_view name) of study/page_texts.h.
#
# The same file is the script that makes the source: cmake -DOUT=... -DDIRECTORY=... -DFILES=a;b -P embed.cmake
if(CMAKE_SCRIPT_MODE_FILE)
  set(source "// Made by cmake/embed.cmake.\n#include \"study/page_texts.h\"\n\n#include <string>\n\n#include \"geometry/error.h\"\n\n")
  string(APPEND source "namespace hsr::internal {\n\nstd::string_view page_text(std::string_view name) {\n")
  foreach(file IN LISTS FILES)
    file(READ ${DIRECTORY}/${file} text HEX)
    # Bytes, whatever they are: compilers limit the length of a string literal, not of an array.
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," text "${text}")
    string(APPEND source "  if (name == \"${file}\") {\n    static constexpr unsigned char bytes[] = {${text}};\n"
      "    return {reinterpret_cast<const char*>(bytes), sizeof bytes};\n  }\n")
  endforeach()
  string(APPEND source "  throw InvariantError(\"pages: there is no \" + std::string(name));\n}\n\n}  // namespace hsr::internal\n")
  file(WRITE ${OUT} "${source}")
  return()
endif()

function(hsr_embed target directory)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/page_texts.cpp)
  list(TRANSFORM ARGN PREPEND ${directory}/ OUTPUT_VARIABLE paths)
  add_custom_command(OUTPUT ${out} DEPENDS ${paths} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    COMMAND ${CMAKE_COMMAND} -DOUT=${out} -DDIRECTORY=${directory} "-DFILES=${ARGN}" -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    VERBATIM)
  target_sources(${target} PRIVATE ${out})
endfunction()
