# SPDX-License-Identifier: MIT
# Makes 60 tasks of the plan of examples/learned_start in WORK_DIR by the program SHIGUSA, and runs
# EXAMPLE, which learns from them.
file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR})
file(READ ${SOURCE_DIR}/examples/learned_start/plan.json plan)
string(REPLACE "\"tasks\": 20000" "\"tasks\": 60" few "${plan}")
string(REPLACE "\"shard_tasks\": 1000" "\"shard_tasks\": 40" few "${few}")
file(WRITE ${WORK_DIR}/plan.json "${few}")
execute_process(COMMAND ${SHIGUSA} dataset ${WORK_DIR}/plan.json --out ${WORK_DIR}/data
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${EXAMPLE} ${WORK_DIR}/data 12 OUTPUT_VARIABLE table
                COMMAND_ERROR_IS_FATAL ANY)
message("${table}")
if(NOT table MATCHES "stands, right_hand[^\n]* [0-9]+ in the table")
  message(FATAL_ERROR "the example shows no table of standing people's hands")
endif()
