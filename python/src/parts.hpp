// The parts of the binding. A part binds some modules and adds nothing to them: values cross as
// they are in C++, and what reads like Python is made of them in the package (tencer/*.py).
#pragma once

#include "bind.hpp"

namespace tencer::python {

void bind_errors(py::module_& module);
void bind_scene(py::module_& module);
void bind_design(py::module_& module);
void bind_runs(py::module_& module);
void bind_actuate(py::module_& module);
void bind_structure(py::module_& module);
void bind_optimize(py::module_& module);
void bind_search(py::module_& module);
void bind_page(py::module_& module);

}  // namespace tencer::python
