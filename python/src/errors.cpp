#include "errors.hpp"

#include "parts.hpp"

namespace tencer::python {

void bind_errors(py::module_& module) {
  // Lives as long as the interpreter, as the translator below does.
  static const py::handle type = [&] {
    py::dict members;
    members["__doc__"] =
        "Bad input. `where` is a place to go to (a file and line, or empty for an argument), "
        "`message` says what is wrong and what would be right.";
    return py::module_::import("builtins")
        .attr("type")("Error", py::make_tuple(py::handle(PyExc_ValueError)), members)
        .release();
  }();
  type.attr("__module__") = "tencer";
  module.attr("Error") = type;
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const BadInput& bad) {
      py::object error = type(bad.error.text());
      error.attr("where") = bad.error.where;
      error.attr("message") = bad.error.message;
      PyErr_SetObject(type.ptr(), error.ptr());
    }
  });
}

}  // namespace tencer::python
