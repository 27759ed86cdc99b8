# Writes OUTPUT, the source of view_template: PAGE with @THREE_JS@, @ORBIT_CONTROLS_JS@,
# @TABLES_JS@ and @SCENE_JS@ replaced by the files of these names, as numbers, for compilers bound
# the length of a string.
file(READ "${PAGE}" page)
foreach(name THREE_JS ORBIT_CONTROLS_JS TABLES_JS SCENE_JS)
  file(READ "${${name}}" script)
  if(script MATCHES "</script")
    message(FATAL_ERROR "${${name}} would end the element it is put in")
  endif()
  string(REPLACE "@${name}@" "${script}" page "${page}")
endforeach()
file(WRITE "${OUTPUT}.html" "${page}")
file(READ "${OUTPUT}.html" bytes HEX)
string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${bytes}")
file(WRITE "${OUTPUT}" "#include \"view_template.hpp\"
namespace tencer::app {
constexpr char bytes[] = {${bytes}};
const std::string_view view_template(bytes, sizeof bytes);
}
")
