# SPDX-License-Identifier: MIT
# One process and two of shigusa-mpi make the same bytes as `shigusa dataset`, and continue a partial data set.
# cmake -D PROGRAM=… -D MPI_PROGRAM=… -D MPIEXEC=… -D WORK_DIR=… -P same_bytes.cmake
file(REMOVE_RECURSE ${WORK_DIR})
file(MAKE_DIRECTORY ${WORK_DIR}/two)
file(WRITE ${WORK_DIR}/plan.json [==[
{"version": 1, "seed": 4, "tasks": 40, "shard_tasks": 5, "series": ["angles"],
 "task": {"character": {"source": "human", "stature_m": {"percentile": [5, 95]}}, "evaluations": 120,
   "goals": [{"effector": "right_hand", "position_m": {"box_m": [[-0.5, 0.4, 0.2], [0.1, 1.6, 0.5]]}}]}}
]==])
# tests may run as root, and on fewer cores than processes
set(ENV{OMPI_ALLOW_RUN_AS_ROOT} 1)
set(ENV{OMPI_ALLOW_RUN_AS_ROOT_CONFIRM} 1)
set(ENV{OMPI_MCA_rmaps_base_oversubscribe} 1)

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK_DIR} RESULT_VARIABLE failed OUTPUT_VARIABLE said
                  ERROR_VARIABLE said)
  if(failed)
    message(FATAL_ERROR "${ARGN}: ${failed}\n${said}")
  endif()
endfunction()
run(${PROGRAM} dataset plan.json --out alone)
run(${MPIEXEC} -n 1 ${MPI_PROGRAM} plan.json one)
# an existing shard is kept
file(COPY ${WORK_DIR}/alone/shard-000003.h5 DESTINATION ${WORK_DIR}/two)
run(${MPIEXEC} -n 2 ${MPI_PROGRAM} plan.json two)
file(GLOB files RELATIVE ${WORK_DIR}/alone ${WORK_DIR}/alone/*)
list(LENGTH files count)
if(NOT count EQUAL 10)
  message(FATAL_ERROR "8 shards, a plan and a card, not ${files}")
endif()
foreach(name IN LISTS files)
  file(SHA256 ${WORK_DIR}/alone/${name} wanted)
  foreach(folder IN ITEMS one two)
    file(SHA256 ${WORK_DIR}/${folder}/${name} sum)
    if(NOT sum STREQUAL wanted)
      message(FATAL_ERROR "${folder}/${name} has other bytes")
    endif()
  endforeach()
endforeach()
# a process that fails ends all of them, and states the reason
execute_process(COMMAND ${MPIEXEC} -n 2 ${MPI_PROGRAM} nothing.json three WORKING_DIRECTORY ${WORK_DIR}
                RESULT_VARIABLE failed ERROR_VARIABLE said)
if(NOT failed OR NOT said MATCHES "nothing.json")
  message(FATAL_ERROR "no plan: ${failed}: ${said}")
endif()
