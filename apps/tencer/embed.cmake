# Writes OUTPUT, the source of view_template: PAGE with @STYLE_CSS@, @THREE_JS@,
# @ORBIT_CONTROLS_JS@ and @CHART_JS@ replaced by the files of these names and @SCRIPTS@ by those
# of the list.
#
# The scripts are ES modules. On the page they stand one after the other in one block, where a name
# that two of them declare is a syntax error; so their imports, one line each and without other
# names, and the word "export" are left out.
file(READ "${PAGE}" page)

function(put name text)
  if(text MATCHES "</script")
    message(FATAL_ERROR "${name} would end the element it is put in")
  endif()
  string(REPLACE "@${name}@" "${text}" page "${page}")
  set(page "${page}" PARENT_SCOPE)
endfunction()

foreach(name STYLE_CSS THREE_JS ORBIT_CONTROLS_JS CHART_JS)
  file(READ "${${name}}" text)
  put(${name} "${text}")
endforeach()
set(scripts "")
foreach(script IN LISTS SCRIPTS)
  file(READ "${script}" text)
  string(REGEX REPLACE "(^|\n)import [^\n]*" "" text "${text}")
  string(REGEX REPLACE "\nexport " "\n" text "${text}")
  string(APPEND scripts "${text}\n")
endforeach()
put(SCRIPTS "${scripts}")
file(WRITE "${OUTPUT}.html" "${page}")
# Compilers read one string in pieces in no time; a list of as many numbers takes them seconds.
file(READ "${OUTPUT}.html" bytes HEX)
string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${bytes}")
string(LENGTH "${bytes}" length)
set(pieces "")
set(piece 16384)
foreach(at RANGE 0 ${length} ${piece})
  string(SUBSTRING "${bytes}" ${at} ${piece} text)
  string(APPEND pieces "\"${text}\"\n")
endforeach()
file(WRITE "${OUTPUT}" "#include \"view_template.hpp\"
namespace tencer::app {
constexpr char bytes[] =
${pieces};
const std::string_view view_template(bytes, sizeof bytes - 1);
}
")
