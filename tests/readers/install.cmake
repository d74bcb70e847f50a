# SPDX-License-Identifier: MIT
# Fetches the second readers' packages, as locked, into FOLDER, once for each lock file. Tests that
# need them skip where this fails: without a network nothing is wrong with what we write.
file(SHA256 ${FOLDER}/package-lock.json lock)
set(stamp ${FOLDER}/node_modules/.lock-${lock})
if(EXISTS ${stamp})
  return()
endif()
execute_process(COMMAND ${NPM} ci --no-audit --no-fund --ignore-scripts WORKING_DIRECTORY ${FOLDER}
                RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(failed)
  file(REMOVE_RECURSE ${FOLDER}/node_modules)
  message("npm cannot fetch the second readers, so their tests skip:\n${said}")
else()
  file(TOUCH ${stamp})
endif()
