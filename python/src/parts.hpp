// The parts of the binding. A part binds some modules and adds nothing to them: values cross as
// they are in C++, and what reads like Python is made of them in the package (tencer/*.py).
#pragma once

#include "bind.hpp"

namespace tencer::python {

void bind_structure(py::module_& module);
void bind_optimize(py::module_& module);

}  // namespace tencer::python
