# SPDX-License-Identifier: MIT
# The library's data: each file becomes a source, generated when CMake configures.

# embed_source(SOURCE HEADER TEXT): generates SOURCE.cpp of the library, with TEXT in its namespace, after HEADER.
function(embed_source source header text)
  file(CONFIGURE OUTPUT ${source}.cpp @ONLY CONTENT [[
#include "@header@"

namespace shigusa {
@text@
}  // namespace shigusa
]])
  target_sources(shigusa PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${source}.cpp)
endfunction()

# read_data(VARIABLE FILE [HEX]): FILE's content; CMake configures again when it changes.
function(read_data variable file)
  set(file ${PROJECT_SOURCE_DIR}/${file})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} content ${ARGN})
  set(${variable} "${content}" PARENT_SCOPE)
endfunction()

# embed_page_part(PART SUFFIX NAME): embeds src/draw/page_PART.SUFFIX as the text NAME, without its licence line.
function(embed_page_part part suffix name)
  read_data(text src/draw/page_${part}.${suffix})
  string(FIND "${text}" "\n" licence)
  string(SUBSTRING "${text}" ${licence} -1 text)
  embed_source(page_${part} draw/page_text.hpp "const std::string_view ${name} = R\"${suffix}(${text})${suffix}\";")
endfunction()
embed_page_part(script js kPageScript)
embed_page_part(style css kPageStyle)

# The start tables: a line `table NAME FEET COORDINATES…` and its rows `X Y Z DIGITS`, separated by tabs.
read_data(rows data/starts.tsv)
string(REGEX REPLACE "#[^\n]*\n" "" rows "${rows}")
string(REGEX MATCHALL "table\t[^\n]*" tables "${rows}")
list(TRANSFORM tables REPLACE "table\t(.*)\t(.*)\t(.*)" "{\"\\3\", \\2, \\1},")
list(JOIN tables "\n" tables)
string(REGEX REPLACE "(-?[0-9]+)\t(-?[0-9]+)\t(-?[0-9]+)\t([0-9A-Za-z]+)\n" "{{\\1, \\2, \\3}, \"\\4\"},\n" rows "${rows}")
string(REGEX REPLACE "table\t([^\t]*)[^\n]*\n" "};\nconstexpr StartRow \\1[] = {\n" rows "${rows}")
string(REGEX REPLACE "^};\n" "" rows "${rows}")
embed_source(start_table_rows generate/start_table.hpp "namespace start_rows {
${rows}};
constexpr StartTable kTables[] = {
${tables}
};
}  // namespace start_rows

std::span<const StartTable> start_tables() { return start_rows::kTables; }")

if(SHIGUSA_MANNEQUIN)
  read_data(bytes data/mannequin.bin HEX)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
  embed_source(mannequin_file draw/mannequin_data.hpp "constexpr unsigned char kMannequinBytes[] = {${bytes}};
const std::span<const unsigned char> kMannequinFile = kMannequinBytes;")
endif()
