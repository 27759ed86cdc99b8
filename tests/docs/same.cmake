# cmake -D PAGE=file -D COMMAND="program;argument;..." -P same.cmake
#
# The page is what the command prints.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${COMMAND} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
file(READ ${PAGE} page)
if(NOT printed STREQUAL page)
  list(JOIN COMMAND " " command)
  message(FATAL_ERROR "${PAGE} is not what this prints: ${command}")
endif()
