# Runs the same seeds twice and compares the printed lines, which contain a digest of every pose,
# force and drawing.
foreach(run first second)
  execute_process(COMMAND ${PROGRAM} --bench ${BENCH} --seeds 40 --seed 7 OUTPUT_VARIABLE ${run}
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
if(NOT first STREQUAL second OR NOT first MATCHES "digest [0-9a-f]+")
  message(FATAL_ERROR "not the same:\n${first}${second}")
endif()
