# cmake -D MANIFEST=file -D MODULES_DIR=folder -P check_includes.cmake
#
# Checks each #include under MODULES_DIR/<module>/{include,src} against the module's declaration
# in the manifest (see tencer_write_manifest). This closes the holes the compiler leaves: a header
# reached through another module's public link, and third-party headers in /usr/include. Checks too
# that the declaration says no more than is so: DEPENDS holds what public headers include, PRIVATE
# what only sources do.
cmake_minimum_required(VERSION 3.25)
include(${MANIFEST})

# Third-party headers: pattern, package, and the modules that may use it at all ("any").
set(third_party
  "^(cholmod|umfpack|SuiteSparse_config|amd|camd|colamd)\\.h$|^suitesparse/ CHOLMOD linalg"
  "^Spectra/ Spectra linalg"
  "^(coin/|coin-or/)?Ip[A-Z][A-Za-z]*\\.hpp$ Ipopt optimize_ipopt"
  "^nlopt\\.hp?p?$ NLopt optimize_nlopt"
  "^nlohmann/ nlohmann_json io"
  "^toml\\+\\+/ tomlplusplus io"
  "^pugixml\\.hpp$ pugixml io"
  "^spdlog/|^fmt/ spdlog none"
  "^range/v3/ range-v3 any")

set(violations "")

# Adds a violation with the line where `text` first occurs in `file`.
function(report file text message)
  file(READ ${file} content)
  string(FIND "${content}" "${text}" position)
  string(SUBSTRING "${content}" 0 ${position} before)
  string(REGEX REPLACE "[^\n]" "" newlines "${before}")
  string(LENGTH "${newlines}" line)
  math(EXPR line "${line} + 1")
  file(RELATIVE_PATH shown ${MODULES_DIR} ${file})
  list(APPEND violations "${shown}:${line}: ${text}: ${message}")
  set(violations "${violations}" PARENT_SCOPE)
endfunction()

# Adds a violation for each module that `part` of the declaration of `name` names but the files,
# `kind` of them, do not use; the modules they use follow.
function(report_unused name part kind)
  foreach(other IN LISTS tencer_${name}_${part})
    if(NOT other IN_LIST ARGN)
      list(APPEND violations
        "${name}/CMakeLists.txt: ${part} names ${other}, of which ${kind} includes anything")
    endif()
  endforeach()
  set(violations "${violations}" PARENT_SCOPE)
endfunction()

# What is wrong with module `name` including a header of module `other`; empty when nothing is.
function(judge_module name other public result)
  set(${result} "" PARENT_SCOPE)
  set(named ${tencer_${name}_DEPENDS} ${tencer_${name}_PRIVATE})
  list(JOIN named " " allowed)
  if(NOT named)
    set(allowed nothing)
  endif()
  list(FIND tencer_modules ${name} own_layer)
  list(FIND tencer_modules ${other} other_layer)
  if(other STREQUAL name OR other IN_LIST tencer_${name}_DEPENDS)
    return()
  elseif(other_layer EQUAL -1)
    set(${result} "there is no module ${other}" PARENT_SCOPE)
  elseif(other_layer GREATER own_layer)
    set(${result} "${other} lies above ${name}, which may use: ${allowed}" PARENT_SCOPE)
  elseif(NOT other IN_LIST named)
    set(${result} "${name} does not name ${other} among what it uses (${allowed})" PARENT_SCOPE)
  elseif(public)
    set(${result} "a public header, but ${name} names ${other} in PRIVATE instead of DEPENDS"
      PARENT_SCOPE)
  endif()
endfunction()

# What is wrong with module `name` including <header>; empty when nothing is.
function(judge name header public result)
  set(${result} "" PARENT_SCOPE)
  if(header MATCHES "^tencer/([^/]+)/")
    judge_module(${name} ${CMAKE_MATCH_1} ${public} problem)
    set(${result} "${problem}" PARENT_SCOPE)
    return()
  endif()
  # The front door of the library is a header without a folder of a module.
  if(header MATCHES "^tencer/" AND EXISTS ${MODULES_DIR}/${name}/include/${header})
    return()
  endif()
  if(header MATCHES "^[a-z_]+$" OR header MATCHES "^(unsupported/)?Eigen/[A-Z]")
    return()
  endif()
  foreach(rule IN LISTS third_party)
    string(REGEX MATCH "^(.*) ([^ ]+) ([^ ]+)$" ignored "${rule}")
    set(pattern "${CMAKE_MATCH_1}")
    set(package ${CMAKE_MATCH_2})
    set(home ${CMAKE_MATCH_3})
    if(NOT header MATCHES "${pattern}")
      continue()
    endif()
    if(home STREQUAL "none")
      set(${result} "${package} is for apps only" PARENT_SCOPE)
    elseif(NOT home STREQUAL "any" AND NOT home STREQUAL name)
      set(${result} "${package} is for module ${home} only" PARENT_SCOPE)
    elseif(public)
      set(${result} "public headers may include std, Eigen and tencer only" PARENT_SCOPE)
    elseif(NOT package IN_LIST tencer_${name}_PACKAGES)
      set(${result} "${name} does not name ${package} in its PACKAGES" PARENT_SCOPE)
    endif()
    return()
  endforeach()
  set(${result} "neither std (C++ names), Eigen, tencer nor a package known to this check" PARENT_SCOPE)
endfunction()

set(count 0)
foreach(name IN LISTS tencer_modules)
  file(GLOB_RECURSE files ${MODULES_DIR}/${name}/include/* ${MODULES_DIR}/${name}/src/*)
  set(used_TRUE "")
  set(used_FALSE "")
  foreach(file IN LISTS files)
    string(FIND ${file} ${MODULES_DIR}/${name}/include/ at)
    set(public FALSE)
    if(at EQUAL 0)
      set(public TRUE)
    endif()
    file(STRINGS ${file} lines REGEX "^[ \t]*#[ \t]*include")
    foreach(line IN LISTS lines)
      math(EXPR count "${count} + 1")
      if(line MATCHES "include[ \t]*(<([^>]+)>)")
        set(shown "${CMAKE_MATCH_1}")
        set(header "${CMAKE_MATCH_2}")
        judge(${name} "${header}" ${public} problem)
        if(header MATCHES "^tencer/([^/]+)/")
          list(APPEND used_${public} ${CMAKE_MATCH_1})
        endif()
        if(problem)
          report(${file} "${shown}" "${problem}")
        endif()
      elseif(line MATCHES "include[ \t]*(\"([^\"]+)\")")
        set(shown "${CMAKE_MATCH_1}")
        cmake_path(GET file PARENT_PATH folder)
        set(root ${MODULES_DIR}/${name}/src)
        if(public)
          report(${file} "${shown}" "a public header names tencer headers as <tencer/...>")
        elseif("${CMAKE_MATCH_2}" MATCHES "\\.\\./" OR NOT
            (EXISTS "${folder}/${CMAKE_MATCH_2}" OR EXISTS "${root}/${CMAKE_MATCH_2}"))
          report(${file} "${shown}" "a private header is named from src/ or from the includer's folder")
        endif()
      else()
        report(${file} "${line}" "cannot tell what this includes")
      endif()
    endforeach()
  endforeach()
  report_unused(${name} DEPENDS "no public header" ${used_TRUE})
  report_unused(${name} PRIVATE "no source" ${used_FALSE})
endforeach()

if(count EQUAL 0)
  message(FATAL_ERROR "no #include found under ${MODULES_DIR}")
endif()
if(violations)
  list(LENGTH violations number)
  list(JOIN violations "\n  " text)
  message(FATAL_ERROR "${number} breaches of the layering:\n  ${text}")
endif()
message(STATUS "${count} includes are as declared")
