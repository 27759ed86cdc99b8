# CPack runs this on what it will pack: manual pages and the changelog are compressed, as Debian has
# them.
file(GLOB_RECURSE pages ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*.1)
list(FILTER pages INCLUDE REGEX "/man1/") # libraries end so, too
file(GLOB_RECURSE changes ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/CHANGELOG.md)
if(NOT pages OR NOT changes)
  message(FATAL_ERROR "no manual page, or no CHANGELOG.md, in ${CPACK_TEMPORARY_INSTALL_DIRECTORY}")
endif()
foreach(page IN LISTS pages)
  execute_process(COMMAND gzip -9nf ${page} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
foreach(file IN LISTS changes)
  cmake_path(GET file PARENT_PATH folder)
  execute_process(COMMAND gzip -9nc ${file} OUTPUT_FILE ${folder}/changelog.gz COMMAND_ERROR_IS_FATAL ANY)
endforeach()
