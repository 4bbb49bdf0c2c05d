# The same seed twice: the printed line carries a digest of every document.
foreach(run first second)
  execute_process(COMMAND ${PROGRAM} --gestures 200 --seed 5 OUTPUT_VARIABLE ${run}
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
if(NOT first STREQUAL second OR NOT first MATCHES "digest [0-9a-f]+")
  message(FATAL_ERROR "not the same documents:\n${first}${second}")
endif()
