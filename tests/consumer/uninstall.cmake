# SPDX-License-Identifier: MIT
# Uninstalls what install.cmake has installed from BUILD_DIR into PREFIX, of which nothing may be left.
execute_process(COMMAND ${CMAKE_COMMAND} -D MANIFEST=${BUILD_DIR}/install_manifest.txt -P
                        ${CMAKE_CURRENT_LIST_DIR}/../../cmake/uninstall.cmake COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE left LIST_DIRECTORIES false ${PREFIX}/*)
if(left OR EXISTS ${PREFIX}/share/shigusa OR EXISTS ${PREFIX}/include/shigusa)
  message(FATAL_ERROR "left behind: ${left}")
endif()
