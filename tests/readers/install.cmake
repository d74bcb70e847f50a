# SPDX-License-Identifier: MIT
# Fetches the independent readers' locked packages into FOLDER, once for each lock file. If this fails,
# tests that need them skip: without a network the written files are not to blame.
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
