# Declares the library's modules: one folder, one target, one include root each.
#
#   tencer_module(NAME [DEPENDS MODULE...] [OPTIONAL MODULE...] [TESTS MODULE...]
#                 [PACKAGES TARGET...])
#
# is all that modules/NAME/CMakeLists.txt holds. The target tencer::NAME is built from src/*.cpp
# and has the public headers include/tencer/NAME/*.hpp, also those made from *.hpp.in, in which CMake
# puts values for @VARIABLES@.
#   DEPENDS   modules it uses, all declared before it in modules/CMakeLists.txt;
#   OPTIONAL  modules it uses when they are part of the build; its sources then see the macro
#             TENCER_WITH_MODULE (in capitals) defined;
#   TESTS     modules declared before it that its tests use and it does not depend on;
#   PACKAGES  third-party targets PACKAGE::TARGET that its sources (never its public headers) use,
#             found with find_package(PACKAGE).
#
# A declaration only records. tencer_add_modules() makes the targets once all are known, for it
# is then that the modules asked for (TENCER_MODULES) and what these depend on can be told from
# the rest, whose packages need not be installed.
include_guard(GLOBAL)

add_library(tencer_warnings INTERFACE)
target_compile_options(tencer_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  $<$<BOOL:${TENCER_WERROR}>:-Werror>)

# Global properties: TENCER_DECLARED and TENCER_MODULES list the modules declared and built, in
# layer order; TENCER_<NAME>_<DEPENDS|OPTIONAL|TESTS|PACKAGES|SOURCE_DIR> hold a module's declaration.
function(tencer_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "DEPENDS;OPTIONAL;TESTS;PACKAGES")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "tencer_module(${name}): unknown arguments ${arg_UNPARSED_ARGUMENTS}")
  endif()
  get_property(declared GLOBAL PROPERTY TENCER_DECLARED)
  foreach(dependency IN LISTS arg_DEPENDS arg_TESTS)
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
  foreach(part DEPENDS OPTIONAL TESTS PACKAGES)
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
      list(APPEND wanted ${depends})
      if(TENCER_TESTS)
        get_property(tests_use GLOBAL PROPERTY TENCER_${name}_TESTS)
        list(APPEND wanted ${tests_use})
      endif()
    endif()
  endforeach()
  foreach(name IN LISTS declared)
    if(name IN_LIST wanted)
      tencer_add_module(${name})
    endif()
  endforeach()
endfunction()

function(tencer_add_module name)
  foreach(part DEPENDS OPTIONAL PACKAGES SOURCE_DIR)
    get_property(${part} GLOBAL PROPERTY TENCER_${name}_${part})
  endforeach()

  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${SOURCE_DIR}/src/*.cpp)
  file(GLOB headers CONFIGURE_DEPENDS ${SOURCE_DIR}/include/tencer/${name}/*.hpp)
  file(GLOB templates CONFIGURE_DEPENDS ${SOURCE_DIR}/include/tencer/${name}/*.hpp.in)
  set(roots ${SOURCE_DIR}/include)
  foreach(template IN LISTS templates)
    set(root ${PROJECT_BINARY_DIR}/include/${name})
    cmake_path(GET template STEM LAST_ONLY header)
    configure_file(${template} ${root}/tencer/${name}/${header} @ONLY)
    list(APPEND headers ${root}/tencer/${name}/${header})
    list(APPEND roots ${root})
  endforeach()
  list(REMOVE_DUPLICATES roots)
  add_library(tencer_${name} STATIC ${sources})
  add_library(tencer::${name} ALIAS tencer_${name})
  target_sources(tencer_${name} PUBLIC
    FILE_SET HEADERS BASE_DIRS ${roots} FILES ${headers})
  # Private headers are named from src on: "folder/header.hpp".
  target_include_directories(tencer_${name} PRIVATE ${SOURCE_DIR}/src)
  target_compile_features(tencer_${name} PUBLIC cxx_std_20)
  set_target_properties(tencer_${name} PROPERTIES
    EXPORT_NAME ${name}
    POSITION_INDEPENDENT_CODE ON
    VERIFY_INTERFACE_HEADER_SETS ${PROJECT_IS_TOP_LEVEL})
  target_link_libraries(tencer_${name}
    PUBLIC Eigen3::Eigen
    PRIVATE $<BUILD_INTERFACE:tencer_warnings>)
  foreach(dependency IN LISTS DEPENDS)
    target_link_libraries(tencer_${name} PUBLIC tencer::${dependency})
  endforeach()
  foreach(dependency IN LISTS OPTIONAL)
    if(TARGET tencer_${dependency})
      string(TOUPPER ${dependency} macro)
      target_link_libraries(tencer_${name} PUBLIC tencer::${dependency})
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
# tools need to know of the declarations: tencer_modules, and for each tencer_<NAME>_DEPENDS (with
# the optional ones that are there) and tencer_<NAME>_PACKAGES (package names).
function(tencer_write_manifest list file)
  get_property(modules GLOBAL PROPERTY ${list})
  set(text "set(tencer_modules ${modules})\n")
  foreach(name IN LISTS modules)
    get_property(depends GLOBAL PROPERTY TENCER_${name}_DEPENDS)
    get_property(optional GLOBAL PROPERTY TENCER_${name}_OPTIONAL)
    get_property(packages GLOBAL PROPERTY TENCER_${name}_PACKAGES)
    foreach(dependency IN LISTS optional)
      if(dependency IN_LIST modules)
        list(APPEND depends ${dependency})
      endif()
    endforeach()
    list(TRANSFORM packages REPLACE "::.*" "")
    list(REMOVE_DUPLICATES packages)
    string(APPEND text "set(tencer_${name}_DEPENDS ${depends})\n"
                       "set(tencer_${name}_PACKAGES ${packages})\n")
  endforeach()
  string(REPLACE ";" " " text "${text}")
  file(CONFIGURE OUTPUT "${file}" CONTENT "${text}" @ONLY)
endfunction()

# tencer_test(NAME [TARGET...]): tests/NAME/*.cpp as one Catch2 program that links module NAME, if
# there is one, run
# by one test a file. (Discovery of single cases by name loses cases whose names hold brackets.)
function(tencer_test name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(test_${name} ${sources})
  target_link_libraries(test_${name} PRIVATE tencer_test_main tencer_warnings ${ARGN})
  if(TARGET tencer::${name})
    get_property(uses GLOBAL PROPERTY TENCER_${name}_TESTS)
    list(TRANSFORM uses PREPEND tencer::)
    target_link_libraries(test_${name} PRIVATE tencer::${name} ${uses})
  endif()
  foreach(source IN LISTS sources)
    file(STRINGS ${source} cases REGEX "TEST_CASE|SCENARIO" LIMIT_COUNT 1)
    cmake_path(GET source STEM stem)
    if(cases)
      add_test(NAME ${name}/${stem}
        COMMAND test_${name} --filenames-as-tags --warn NoTests "[#${stem}]")
    endif()
  endforeach()
endfunction()
