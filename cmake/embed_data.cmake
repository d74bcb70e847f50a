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
embed_page_part(work js kPageWork)
embed_page_part(style css kPageStyle)

if(SHIGUSA_STARTS)
  read_data(rows data/starts.tsv)
endif()
embed_source(start_table_rows generate/start_table.hpp "#pragma GCC diagnostic ignored \"-Woverlength-strings\"
const std::string_view kStartText = R\"starts(${rows})starts\";")

if(SHIGUSA_MANNEQUIN)
  read_data(bytes data/mannequin.bin HEX)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
  embed_source(mannequin_file draw/mannequin_data.hpp "constexpr unsigned char kMannequinBytes[] = {${bytes}};
const std::span<const unsigned char> kMannequinFile = kMannequinBytes;")
endif()
