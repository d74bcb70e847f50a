# SPDX-License-Identifier: MIT
# Configures, builds and runs the consumer in FOLDER beside this file, with the shigusa installed in PREFIX;
# DEFINITIONS are further -D options. The one in C++ also builds the README's program.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/${FOLDER} -B ${WORK_DIR}/build -G ${GENERATOR}
    -D CMAKE_PREFIX_PATH=${PREFIX} -D CMAKE_BUILD_TYPE=${CONFIG} ${DEFINITIONS})
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
run(${WORK_DIR}/build/consumer)
if(EXISTS ${WORK_DIR}/build/readme)
  run(${CMAKE_COMMAND} -E chdir ${WORK_DIR} build/readme)
endif()
