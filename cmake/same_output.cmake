# Run as a script (cmake -DPROGRAM=... [-DARGUMENTS=...] -DEXPECTED=... -P same_output.cmake): fails if the program
# prints something other than the expected file.

execute_process(COMMAND "${PROGRAM}" ${ARGUMENTS} OUTPUT_VARIABLE printed ERROR_VARIABLE printed)
file(READ "${EXPECTED}" expected)
if(NOT printed STREQUAL expected)
  message(FATAL_ERROR "${PROGRAM} printed:\n${printed}\nbut ${EXPECTED} is:\n${expected}")
endif()
