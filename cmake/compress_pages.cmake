# CPack runs this on what it will pack: manual pages and the changelog are compressed, as Debian has
# them.
file(GLOB_RECURSE manual ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/man1/*.1)
file(GLOB_RECURSE changelog ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/doc/*/CHANGELOG.md)
foreach(file IN LISTS manual)
  execute_process(COMMAND gzip -9nf ${file} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
foreach(file IN LISTS changelog)
  cmake_path(GET file PARENT_PATH folder)
  execute_process(COMMAND gzip -9nc ${file} OUTPUT_FILE ${folder}/changelog.gz COMMAND_ERROR_IS_FATAL ANY)
endforeach()
