// What every part of the binding shares: the headers that take long to read, and the parts' names.
//
// A part binds one module and adds nothing to it. Values cross as they are in C++; what reads like
// Python is made of them in the package (tencer/*.py).
#pragma once

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <Eigen/Core>

namespace tencer::python {

namespace py = pybind11;

void bind_errors(py::module_& module);
void bind_scene(py::module_& module);
void bind_design(py::module_& module);
void bind_runs(py::module_& module);

}  // namespace tencer::python
