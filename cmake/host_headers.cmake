# SPDX-License-Identifier: MIT
# Header-only libraries of the build machine for a cross compiler: find_package looks for packages of
# the target machine, and the whole of /usr/include would bring the build machine's C library. So a
# folder has links to these libraries alone.
set(host_headers ${PROJECT_BINARY_DIR}/host_headers)
file(MAKE_DIRECTORY ${host_headers})
foreach(folder IN ITEMS tl fmt nlohmann CLI)
  if(NOT EXISTS /usr/include/${folder})
    message(FATAL_ERROR "/usr/include/${folder} is not there; scripts/install_dependencies wasm")
  endif()
  file(CREATE_LINK /usr/include/${folder} ${host_headers}/${folder} SYMBOLIC)
endforeach()
foreach(target IN ITEMS tl::expected fmt::fmt nlohmann_json::nlohmann_json CLI11::CLI11)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE ${host_headers})
endforeach()
# without std::locale, of which no text here makes use, and which is 2 % of a browser's module
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY FMT_STATIC_THOUSANDS_SEPARATOR=',')
