# tencer_test(NAME [MODULE...]): tests/NAME/*.cpp as one Catch2 program, run by one test a file.
# (Discovery of single cases by name loses cases whose names hold brackets.) Where NAME is a module,
# the program sees what the module sees: it, the modules it names and its private headers. It also
# sees the MODULEs; where one of them is not part of the build, there is no such program.
include_guard(GLOBAL)

function(tencer_test name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  get_property(built GLOBAL PROPERTY TENCER_MODULES)
  set(missing ${ARGN})
  list(REMOVE_ITEM missing ${built})
  if(missing OR NOT sources)
    return()
  endif()
  list(TRANSFORM ARGN PREPEND tencer:: OUTPUT_VARIABLE uses)
  add_executable(test_${name} ${sources})
  target_link_libraries(test_${name} PRIVATE tencer_test_main tencer_warnings ${uses})
  if(TARGET tencer::${name})
    get_property(folder GLOBAL PROPERTY TENCER_${name}_SOURCE_DIR)
    get_property(private GLOBAL PROPERTY TENCER_${name}_PRIVATE)
    list(TRANSFORM private PREPEND tencer::)
    target_include_directories(test_${name} PRIVATE ${folder}/src)
    target_link_libraries(test_${name} PRIVATE tencer::${name} ${private})
  endif()
  tencer_precompile(test_${name} tests)
  foreach(source IN LISTS sources)
    file(STRINGS ${source} cases REGEX "TEST_CASE|SCENARIO" LIMIT_COUNT 1)
    cmake_path(GET source STEM stem)
    # A hidden case is for whoever runs it by name.
    if(cases AND NOT cases MATCHES "\\[\\.")
      add_test(NAME ${name}/${stem}
        COMMAND test_${name} --filenames-as-tags --warn NoTests "[#${stem}]")
    endif()
  endforeach()
endfunction()

# tencer_label_tests(LABEL TEST...): the tests get the label too, and the target LABEL_tests builds
# their programs. Tests of modules left out (TENCER_MODULES) are passed over.
function(tencer_label_tests label)
  add_custom_target(${label}_tests)
  get_property(tests DIRECTORY PROPERTY TESTS)
  foreach(test IN LISTS ARGN)
    if(test IN_LIST tests)
      set_property(TEST ${test} APPEND PROPERTY LABELS ${label})
      cmake_path(GET test PARENT_PATH name)
      add_dependencies(${label}_tests test_${name})
    elseif(NOT TENCER_MODULES)
      message(FATAL_ERROR "there is no test ${test} to get the label ${label}")
    endif()
  endforeach()
endfunction()
