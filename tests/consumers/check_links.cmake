# cmake -D PROGRAM=file -D WITHOUT=regex [-D WITH=regex] -P check_links.cmake
#
# Fails if the program loads a shared library that matches WITHOUT, or none that matches WITH.
execute_process(COMMAND ldd ${PROGRAM} OUTPUT_VARIABLE libraries COMMAND_ERROR_IS_FATAL ANY)
if(libraries MATCHES "${WITHOUT}")
  message(FATAL_ERROR "${PROGRAM} loads ${CMAKE_MATCH_0}:\n${libraries}")
endif()
if(DEFINED WITH AND NOT libraries MATCHES "${WITH}")
  message(FATAL_ERROR "${PROGRAM} loads nothing like ${WITH}:\n${libraries}")
endif()
