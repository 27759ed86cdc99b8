# cmake -D PAGE=docs/embedding.md -D EXAMPLES=folder -P check_page.cmake
#
# The programs that the page shows are those that are built and run here, to the letter.
cmake_minimum_required(VERSION 3.25)
file(READ ${PAGE} page)
file(GLOB sources ${EXAMPLES}/*.cpp)
set(missing "")
foreach(source IN LISTS sources)
  file(READ ${source} text)
  string(FIND "${page}" "```cpp\n${text}```\n" at)
  if(at LESS 0)
    list(APPEND missing ${source})
  endif()
endforeach()
if(missing)
  list(JOIN missing "\n  " missing)
  message(FATAL_ERROR "${PAGE} does not show these programs as they are:\n  ${missing}")
endif()
