# Runs the same seed twice and compares the printed lines, which contain a digest of every force.
foreach(run first second)
  execute_process(COMMAND ${PROGRAM} --ticks 300000 --seed 5 OUTPUT_VARIABLE ${run}
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
if(NOT first STREQUAL second OR NOT first MATCHES "digest [0-9a-f]+")
  message(FATAL_ERROR "not the same forces:\n${first}${second}")
endif()
