# Declares the library's modules: one folder, one target, one include root each.
#
#   tencer_module(NAME [DEPENDS MODULE...] [PACKAGES TARGET...])
#
# in modules/NAME/CMakeLists.txt builds src/*.cpp into the target tencer::NAME with the
# public headers include/tencer/NAME/*.hpp. DEPENDS names the modules it may use, all
# declared earlier; PACKAGES names third-party targets its sources (not its headers) use.
include_guard(GLOBAL)

add_library(tencer_warnings INTERFACE)
target_compile_options(tencer_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  $<$<BOOL:${TENCER_WERROR}>:-Werror>)

function(tencer_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "DEPENDS;PACKAGES")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "tencer_module(${name}): unknown arguments ${arg_UNPARSED_ARGUMENTS}")
  endif()
  foreach(dependency IN LISTS arg_DEPENDS)
    if(NOT TARGET tencer_${dependency})
      message(FATAL_ERROR
        "module ${name} depends on ${dependency}, which is not declared before it in modules/CMakeLists.txt")
    endif()
  endforeach()

  file(GLOB sources CONFIGURE_DEPENDS src/*.cpp)
  file(GLOB headers CONFIGURE_DEPENDS include/tencer/${name}/*.hpp)
  add_library(tencer_${name} STATIC ${sources})
  add_library(tencer::${name} ALIAS tencer_${name})
  target_sources(tencer_${name} PUBLIC
    FILE_SET HEADERS BASE_DIRS include FILES ${headers})
  target_compile_features(tencer_${name} PUBLIC cxx_std_20)
  set_target_properties(tencer_${name} PROPERTIES
    EXPORT_NAME ${name}
    POSITION_INDEPENDENT_CODE ON
    VERIFY_INTERFACE_HEADER_SETS ON
    TENCER_DEPENDS "${arg_DEPENDS}")
  target_link_libraries(tencer_${name} PUBLIC Eigen3::Eigen)
  foreach(dependency IN LISTS arg_DEPENDS)
    target_link_libraries(tencer_${name} PUBLIC tencer::${dependency})
  endforeach()
  target_link_libraries(tencer_${name} PRIVATE ${arg_PACKAGES} $<BUILD_INTERFACE:tencer_warnings>)
  set_property(GLOBAL APPEND PROPERTY TENCER_MODULES ${name})
endfunction()

# tencer_test(NAME): tests/NAME/*.cpp as one Catch2 program that links the module NAME.
function(tencer_test name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(test_${name} ${sources})
  target_link_libraries(test_${name} PRIVATE tencer::${name} tencer_test_main tencer_warnings ${ARGN})
  catch_discover_tests(test_${name} TEST_PREFIX "${name}: " PROPERTIES LABELS ${name})
endfunction()
