# cmake -D PAGES="file;..." -D PROGRAM=file -P check_page.cmake
#
# The pages show the program as it is built and run here, to the letter.
cmake_minimum_required(VERSION 3.25)
file(READ ${PROGRAM} text)
foreach(page IN LISTS PAGES)
  file(READ ${page} shown)
  string(FIND "${shown}" "```cpp\n${text}```\n" at)
  if(at LESS 0)
    message(SEND_ERROR "${page} does not show ${PROGRAM} as it is")
  endif()
endforeach()
