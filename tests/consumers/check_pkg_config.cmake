# cmake -D COMPILER=file -D FLAGS=text -D SOURCE=file -D MODULE=name -D PC_FILES=folder
#   -D VERSION=x.y.z -D WORK=folder -P check_pkg_config.cmake
#
# All .pc files there are complete; a program that is compiled and linked with what pkg-config says of
# the module runs.
cmake_minimum_required(VERSION 3.25)
set(ENV{PKG_CONFIG_PATH} ${PC_FILES})
file(MAKE_DIRECTORY ${WORK})

function(ask result)
  execute_process(COMMAND pkg-config ${ARGN} OUTPUT_VARIABLE out OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)
  set(${result} "${out}" PARENT_SCOPE)
endfunction()

file(GLOB files ${PC_FILES}/tencer*.pc)
list(LENGTH files count)
if(count LESS 2)
  message(FATAL_ERROR "no .pc files in ${PC_FILES}")
endif()
foreach(file IN LISTS files)
  cmake_path(GET file STEM LAST_ONLY name)
  ask(version --print-errors --modversion ${name})
  ask(flags --cflags --libs ${name})
  if(NOT version STREQUAL VERSION)
    message(SEND_ERROR "${name} is said to be ${version}, not ${VERSION}")
  endif()
endforeach()

ask(flags --cflags --libs tencer-${MODULE})
separate_arguments(flags UNIX_COMMAND "${FLAGS} ${flags}")
execute_process(COMMAND ${COMPILER} -std=c++20 ${SOURCE} ${flags} -o ${WORK}/program
  COMMAND_ERROR_IS_FATAL ANY)
set(ENV{LD_LIBRARY_PATH} ${PC_FILES}/..) # where the libraries are shared
execute_process(COMMAND ${WORK}/program COMMAND_ERROR_IS_FATAL ANY)
