# The install rules: the program, its manual page and completions, its pages and examples, libraries,
# headers, pkg-config files, and a CMake package whose components are the modules. Each module is an
# export set of its own, so that a consumer loads only the components asked for and finds only the
# third-party packages these need. The Python module is installed by python/CMakeLists.txt.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/tencer)

get_property(modules GLOBAL PROPERTY TENCER_MODULES)
foreach(name IN LISTS modules)
  install(TARGETS tencer_${name} EXPORT tencer_${name}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  # Shared libraries find each other wherever the prefix is moved to.
  set_target_properties(tencer_${name} PROPERTIES INSTALL_RPATH $ORIGIN)
  install(EXPORT tencer_${name} NAMESPACE tencer:: DESTINATION ${package_dir}
    FILE tencer-${name}.cmake)
endforeach()

tencer_write_manifest(TENCER_MODULES ${PROJECT_BINARY_DIR}/package/tencer-modules.cmake)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/tencerConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
file(GLOB find_modules CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/Find*.cmake)
install(FILES
  ${CMAKE_CURRENT_LIST_DIR}/tencerConfig.cmake
  ${PROJECT_BINARY_DIR}/package/tencerConfigVersion.cmake
  ${PROJECT_BINARY_DIR}/package/tencer-modules.cmake
  DESTINATION ${package_dir})
install(FILES ${find_modules} DESTINATION ${package_dir}/find)
include(TencerPkgConfig)

if(TARGET tencer)
  cmake_path(RELATIVE_PATH CMAKE_INSTALL_FULL_LIBDIR BASE_DIRECTORY ${CMAKE_INSTALL_FULL_BINDIR}
    OUTPUT_VARIABLE from_program_to_libraries)
  set_target_properties(tencer PROPERTIES INSTALL_RPATH $ORIGIN/${from_program_to_libraries})
  install(TARGETS tencer RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  get_target_property(told tencer TENCER_TOLD)
  if(told)
    install(FILES ${told}/tencer.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
    install(FILES ${told}/tencer.bash RENAME tencer
      DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
    # Debian's zsh looks for those of packages in share/zsh/vendor-completions.
    set(TENCER_ZSH_DIR ${CMAKE_INSTALL_DATADIR}/zsh/site-functions
      CACHE STRING "Where zsh looks for completions, from the prefix on")
    install(FILES ${told}/_tencer DESTINATION ${TENCER_ZSH_DIR})
    install(FILES ${told}/tencer.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
  endif()
endif()
# The pages name each other and the examples by the places they have in the sources.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs ${PROJECT_SOURCE_DIR}/examples
  DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN make EXCLUDE PATTERN mkdocs.yml EXCLUDE)
