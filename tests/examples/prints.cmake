# Runs an example and compares what it prints with a file. With REWRITE in the environment the file is written instead.
# cmake -DPROGRAM=... -DARGUMENTS="..." -DEXPECTED=... -P prints.cmake
execute_process(COMMAND ${PROGRAM} ${ARGUMENTS} OUTPUT_VARIABLE printed ERROR_VARIABLE error RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} ended with ${status}: ${error}")
endif()
if(DEFINED ENV{REWRITE})
  file(WRITE ${EXPECTED} "${printed}")
  return()
endif()
file(READ ${EXPECTED} expected)
if(NOT printed STREQUAL expected)
  message(FATAL_ERROR "${PROGRAM} printed\n${printed}instead of\n${expected}")
endif()
