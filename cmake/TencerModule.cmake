# Declares the library's modules: one folder, one target, one include root each.
#
#   tencer_module(NAME [DEPENDS MODULE...] [PRIVATE MODULE...] [OPTIONAL MODULE...]
#                 [PACKAGES TARGET...])
#
# is all that modules/NAME/CMakeLists.txt holds. The target tencer::NAME is built from the sources in
# src/ and has the public headers in include/tencer/, also those made from *.hpp.in, in which CMake
# puts values for @VARIABLES@.
#   DEPENDS   modules that its public headers use: their headers reach its users too;
#   PRIVATE   modules that only its sources use: its users do not see their headers;
#   OPTIONAL  modules that only its sources use, when they are part of the build; the sources then
#             see the macro TENCER_WITH_MODULE (in capitals) defined;
#   PACKAGES  third-party targets PACKAGE::TARGET that its sources (never its public headers) use,
#             found with find_package(PACKAGE).
# All modules named are declared before it in modules/CMakeLists.txt. The test `layering` compares
# what is named with what is included.
#
# A declaration only records. tencer_add_modules() makes the targets once all are known, for it
# is then that the modules asked for (TENCER_MODULES) and what these depend on can be told from
# the rest, whose packages need not be installed.
include_guard(GLOBAL)
include(TencerTarget)

# Global properties: TENCER_DECLARED and TENCER_MODULES list the modules declared and built, in
# layer order; TENCER_<NAME>_<DEPENDS|PRIVATE|OPTIONAL|PACKAGES|SOURCE_DIR> hold a module's
# declaration.
function(tencer_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "DEPENDS;PRIVATE;OPTIONAL;PACKAGES")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "tencer_module(${name}): unknown arguments ${arg_UNPARSED_ARGUMENTS}")
  endif()
  get_property(declared GLOBAL PROPERTY TENCER_DECLARED)
  foreach(dependency IN LISTS arg_DEPENDS arg_PRIVATE)
    if(NOT dependency IN_LIST declared)
      message(FATAL_ERROR
        "module ${name} depends on ${dependency}, which is not declared before it in modules/CMakeLists.txt")
    endif()
  endforeach()
  foreach(target IN LISTS arg_PACKAGES)
    if(NOT target MATCHES "^.+::.+$")
      message(FATAL_ERROR "tencer_module(${name}): PACKAGES wants PACKAGE::TARGET, not ${target}")
    endif()
  endforeach()
  # A module left out of the build by an option is not declared at all.
  foreach(dependency IN LISTS arg_OPTIONAL)
    if(NOT EXISTS "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../modules/${dependency}")
      message(FATAL_ERROR "module ${name} names ${dependency}, but there is no modules/${dependency}")
    elseif(NOT dependency IN_LIST declared)
      list(REMOVE_ITEM arg_OPTIONAL ${dependency})
    endif()
  endforeach()
  set_property(GLOBAL APPEND PROPERTY TENCER_DECLARED ${name})
  foreach(part DEPENDS PRIVATE OPTIONAL PACKAGES)
    set_property(GLOBAL PROPERTY TENCER_${name}_${part} "${arg_${part}}")
  endforeach()
  set_property(GLOBAL PROPERTY TENCER_${name}_SOURCE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
endfunction()

# The targets of the modules in TENCER_MODULES and of all they depend on.
function(tencer_add_modules)
  get_property(declared GLOBAL PROPERTY TENCER_DECLARED)
  set(wanted ${TENCER_MODULES})
  if(NOT wanted)
    set(wanted ${declared})
  endif()
  foreach(name IN LISTS wanted)
    if(NOT name IN_LIST declared)
      list(JOIN declared " " known)
      message(FATAL_ERROR "TENCER_MODULES names '${name}', but the modules are: ${known}")
    endif()
  endforeach()
  # From the top layer down, each module adds what it depends on.
  set(top_down ${declared})
  list(REVERSE top_down)
  foreach(name IN LISTS top_down)
    if(name IN_LIST wanted)
      get_property(depends GLOBAL PROPERTY TENCER_${name}_DEPENDS)
      get_property(private GLOBAL PROPERTY TENCER_${name}_PRIVATE)
      list(APPEND wanted ${depends} ${private})
    endif()
  endforeach()
  foreach(name IN LISTS declared)
    if(name IN_LIST wanted)
      tencer_add_module(${name})
    endif()
  endforeach()
endfunction()

function(tencer_add_module name)
  foreach(part DEPENDS PRIVATE OPTIONAL PACKAGES SOURCE_DIR)
    get_property(${part} GLOBAL PROPERTY TENCER_${name}_${part})
  endforeach()

  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${SOURCE_DIR}/src/*.cpp)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${SOURCE_DIR}/include/*.hpp)
  file(GLOB_RECURSE templates CONFIGURE_DEPENDS ${SOURCE_DIR}/include/*.hpp.in)
  set(roots ${SOURCE_DIR}/include)
  foreach(template IN LISTS templates)
    set(root ${PROJECT_BINARY_DIR}/include/${name})
    cmake_path(GET template STEM LAST_ONLY header)
    configure_file(${template} ${root}/tencer/${name}/${header} @ONLY)
    list(APPEND headers ${root}/tencer/${name}/${header})
    list(APPEND roots ${root})
  endforeach()
  list(REMOVE_DUPLICATES roots)
  add_library(tencer_${name} ${sources})
  add_library(tencer::${name} ALIAS tencer_${name})
  target_sources(tencer_${name} PUBLIC
    FILE_SET HEADERS BASE_DIRS ${roots} FILES ${headers})
  # Private headers are named from src on: "folder/header.hpp".
  target_include_directories(tencer_${name} PRIVATE ${SOURCE_DIR}/src)
  target_compile_features(tencer_${name} PUBLIC cxx_std_20)
  # Before 1.0 a minor version may change what is in a header.
  set_target_properties(tencer_${name} PROPERTIES
    EXPORT_NAME ${name}
    DEFINE_SYMBOL ""
    POSITION_INDEPENDENT_CODE ON
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  tencer_precompile(tencer_${name} modules ${TENCER_PRECOMPILED})
  target_link_libraries(tencer_${name}
    PUBLIC Eigen3::Eigen
    PRIVATE $<BUILD_INTERFACE:tencer_warnings>)
  foreach(dependency IN LISTS DEPENDS)
    target_link_libraries(tencer_${name} PUBLIC tencer::${dependency})
  endforeach()
  foreach(dependency IN LISTS PRIVATE)
    target_link_libraries(tencer_${name} PRIVATE tencer::${dependency})
  endforeach()
  foreach(dependency IN LISTS OPTIONAL)
    if(TARGET tencer_${dependency})
      string(TOUPPER ${dependency} macro)
      target_link_libraries(tencer_${name} PRIVATE tencer::${dependency})
      target_compile_definitions(tencer_${name} PRIVATE TENCER_WITH_${macro})
    endif()
  endforeach()
  foreach(target IN LISTS PACKAGES)
    string(REGEX REPLACE "::.*" "" package ${target})
    find_package(${package} REQUIRED)
    target_link_libraries(tencer_${name} PRIVATE ${target})
  endforeach()
  set_property(GLOBAL APPEND PROPERTY TENCER_MODULES ${name})
endfunction()

# Writes `file`, which sets for the modules in `list` (the name of a global property) what other
# tools need to know of the declarations: tencer_modules, and for each tencer_<NAME>_DEPENDS,
# tencer_<NAME>_PRIVATE (with the optional ones that are there) and tencer_<NAME>_PACKAGES (package
# names); and tencer_shared, whether they are shared libraries.
function(tencer_write_manifest list file)
  get_property(modules GLOBAL PROPERTY ${list})
  set(text "set(tencer_modules ${modules})\nset(tencer_shared ${BUILD_SHARED_LIBS})\n")
  foreach(name IN LISTS modules)
    foreach(part DEPENDS PRIVATE OPTIONAL PACKAGES)
      get_property(${part} GLOBAL PROPERTY TENCER_${name}_${part})
    endforeach()
    foreach(dependency IN LISTS OPTIONAL)
      if(dependency IN_LIST modules)
        list(APPEND PRIVATE ${dependency})
      endif()
    endforeach()
    list(TRANSFORM PACKAGES REPLACE "::.*" "")
    list(REMOVE_DUPLICATES PACKAGES)
    foreach(part DEPENDS PRIVATE PACKAGES)
      string(APPEND text "set(tencer_${name}_${part} ${${part}})\n")
    endforeach()
  endforeach()
  string(REPLACE ";" " " text "${text}")
  file(CONFIGURE OUTPUT "${file}" CONTENT "${text}" @ONLY)
endfunction()
