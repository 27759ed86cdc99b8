# find_package(tencer COMPONENTS MODULE...) defines tencer::MODULE for each module named and for
# those it depends on, and finds the third-party packages of these and no others. Without
# COMPONENTS, all modules.
include(CMakeFindDependencyMacro)
include(${CMAKE_CURRENT_LIST_DIR}/tencer-modules.cmake)

set(tencer_wanted ${tencer_FIND_COMPONENTS})
if(NOT tencer_wanted)
  set(tencer_wanted ${tencer_modules})
endif()
foreach(tencer_name IN LISTS tencer_wanted)
  if(tencer_name IN_LIST tencer_modules)
    set(tencer_${tencer_name}_FOUND TRUE)
  elseif(tencer_FIND_REQUIRED_${tencer_name})
    list(JOIN tencer_modules " " tencer_known)
    set(tencer_FOUND FALSE)
    set(tencer_NOT_FOUND_MESSAGE
      "tencer has no module '${tencer_name}' here; its modules are: ${tencer_known}")
    return()
  endif()
endforeach()

# From the top layer down, each module adds what it depends on.
set(tencer_top_down ${tencer_modules})
list(REVERSE tencer_top_down)
foreach(tencer_name IN LISTS tencer_top_down)
  if(tencer_name IN_LIST tencer_wanted)
    list(APPEND tencer_wanted ${tencer_${tencer_name}_DEPENDS} ${tencer_${tencer_name}_PRIVATE})
  endif()
endforeach()

set(tencer_module_path ${CMAKE_MODULE_PATH})
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR}/find)
find_dependency(Eigen3 3.4 NO_MODULE)
foreach(tencer_name IN LISTS tencer_modules)
  if(tencer_name IN_LIST tencer_wanted)
    foreach(tencer_package IN LISTS tencer_${tencer_name}_PACKAGES)
      find_dependency(${tencer_package})
    endforeach()
    include(${CMAKE_CURRENT_LIST_DIR}/tencer-${tencer_name}.cmake)
  endif()
endforeach()
set(CMAKE_MODULE_PATH ${tencer_module_path})
