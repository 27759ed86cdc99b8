# cmake -D TENCER=file -D VERSION=x.y.z -D PAGES=folder -P check_program.cmake
#
# The installed program runs, and the files that the README names are beside it.
cmake_minimum_required(VERSION 3.25)

function(expect_said option part)
  execute_process(COMMAND ${TENCER} ${option} OUTPUT_VARIABLE out COMMAND_ERROR_IS_FATAL ANY)
  string(FIND "${out}" "${part}" at)
  if(at EQUAL -1)
    message(SEND_ERROR "${TENCER} ${option} says nothing of '${part}': ${out}")
  endif()
endfunction()

expect_said(--version ${VERSION})
expect_said(--help design)

file(READ ${PAGES}/README.md readme)
# Code has no links; brackets would keep the matches from being a list.
string(REGEX REPLACE "```[^`]*```" "" readme "${readme}")
string(REPLACE "](" "->" readme "${readme}")
string(REGEX MATCHALL "->[^):]+\\)" links "${readme}")
list(LENGTH links count)
if(count LESS 5)
  message(SEND_ERROR "only ${count} links in ${PAGES}/README.md")
endif()
foreach(link IN LISTS links)
  string(REGEX REPLACE "->(.+)\\)" "\\1" link "${link}")
  if(NOT EXISTS ${PAGES}/${link})
    message(SEND_ERROR "README.md names ${link}, which is not in ${PAGES}")
  endif()
endforeach()
