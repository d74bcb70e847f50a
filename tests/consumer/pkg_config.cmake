# SPDX-License-Identifier: MIT
# Compiles and runs the consumer in C++, and with a compiler of C (CC) that in C, with the shigusa installed in PREFIX, by the output of pkg-config, which for a
# shared library (SHARED) does not include its own dependencies. FLAGS are further flags of CXX.
set(ENV{PKG_CONFIG_PATH} ${PREFIX}/${LIBDIR}/pkgconfig)
function(ask variable)
  execute_process(COMMAND pkg-config ${ARGN} OUTPUT_VARIABLE answer OUTPUT_STRIP_TRAILING_WHITESPACE
                  COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(answer UNIX_COMMAND "${answer}")
  set(${variable} "${answer}" PARENT_SCOPE)
endfunction()
ask(version --modversion shigusa)
ask(flags --cflags --libs shigusa)
ask(all_flags --static --libs shigusa)

if(NOT all_flags MATCHES "-lshigusa.*-lfmt")
  message(FATAL_ERROR "pkg-config --static --libs shigusa leaves out what the library needs: ${all_flags}")
endif()
if(SHARED AND flags MATCHES "-lfmt")
  message(FATAL_ERROR "pkg-config --libs shigusa tells of more than the shared library: ${flags}")
endif()
separate_arguments(FLAGS UNIX_COMMAND "${FLAGS}")
cmake_path(GET PROGRAM PARENT_PATH folder)
file(MAKE_DIRECTORY ${folder})
execute_process(COMMAND ${CXX} -std=c++20 ${FLAGS} ${CMAKE_CURRENT_LIST_DIR}/cxx/main.cpp -o ${PROGRAM} ${flags}
                        -Wl,-rpath,${PREFIX}/${LIBDIR} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PROGRAM} ${version} COMMAND_ERROR_IS_FATAL ANY)
if(CC)
  ask(flags --cflags --libs shigusa_c)
  execute_process(COMMAND ${CC} ${CMAKE_CURRENT_LIST_DIR}/c/main.c -o ${PROGRAM}_c ${flags}
                          -Wl,-rpath,${PREFIX}/${LIBDIR} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${PROGRAM}_c COMMAND_ERROR_IS_FATAL ANY)
endif()
