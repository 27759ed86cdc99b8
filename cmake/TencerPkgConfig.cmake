# pkg-config files: tencer-MODULE.pc for each module, which asks for those it depends on and for the
# third-party libraries that it is linked with, and tencer.pc, the front door (tencer/design.hpp).
# They name their folders from where they lie, so that an installed tencer can be moved.
cmake_path(RELATIVE_PATH CMAKE_INSTALL_PREFIX
  BASE_DIRECTORY ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig OUTPUT_VARIABLE from_pc_to_prefix)

# What is linked for a package that a module names (PACKAGES); headers alone need nothing.
set(link_CHOLMOD -lcholmod)
set(link_Ipopt -lipopt)
set(link_NLopt -lnlopt)
set(link_pugixml -lpugixml)
set(link_tomlplusplus -ltomlplusplus)
set(headers_only Spectra nlohmann_json range-v3)

# tencer_pkg_config(NAME DESCRIPTION [REQUIRES..] [PRIVATE..] [LIBS..] [LIBS_PRIVATE..]): NAME.pc.
# Static libraries need what they were built with, so for them nothing is private.
function(tencer_pkg_config pc_name pc_description)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "REQUIRES;PRIVATE;LIBS;LIBS_PRIVATE")
  if(NOT BUILD_SHARED_LIBS)
    list(APPEND arg_REQUIRES ${arg_PRIVATE})
    list(APPEND arg_LIBS ${arg_LIBS_PRIVATE})
    set(arg_PRIVATE "")
    set(arg_LIBS_PRIVATE "")
  endif()
  list(JOIN arg_REQUIRES " " pc_requires)
  list(JOIN arg_PRIVATE " " pc_requires_private)
  list(JOIN arg_LIBS " " pc_libs)
  list(JOIN arg_LIBS_PRIVATE " " pc_libs_private)
  set(file ${PROJECT_BINARY_DIR}/package/${pc_name}.pc)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/tencer.pc.in ${file} @ONLY)
  install(FILES ${file} DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

get_property(modules GLOBAL PROPERTY TENCER_MODULES)
foreach(name IN LISTS modules)
  foreach(part DEPENDS PRIVATE OPTIONAL PACKAGES)
    get_property(${part} GLOBAL PROPERTY TENCER_${name}_${part})
  endforeach()
  foreach(dependency IN LISTS OPTIONAL)
    if(TARGET tencer_${dependency})
      list(APPEND PRIVATE ${dependency})
    endif()
  endforeach()
  list(TRANSFORM DEPENDS PREPEND tencer-)
  list(TRANSFORM PRIVATE PREPEND tencer-)
  set(libs "")
  foreach(target IN LISTS PACKAGES)
    string(REGEX REPLACE "::.*" "" package ${target})
    if(NOT DEFINED link_${package} AND NOT package IN_LIST headers_only)
      message(FATAL_ERROR "module ${name} uses ${package}: say in cmake/TencerPkgConfig.cmake how it is linked")
    endif()
    list(APPEND libs ${link_${package}})
  endforeach()
  tencer_pkg_config(tencer-${name} "The module ${name} of tencer" REQUIRES eigen3 ${DEPENDS}
    PRIVATE ${PRIVATE} LIBS -L\${libdir} -ltencer_${name} LIBS_PRIVATE ${libs})
endforeach()
if(TARGET tencer_pipeline)
  tencer_pkg_config(tencer "${PROJECT_DESCRIPTION}" REQUIRES tencer-pipeline)
endif()
