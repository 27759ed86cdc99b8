// The headers of every part of the binding that take long to read; compiled once.
#pragma once

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace tencer::python {

namespace py = pybind11;

}  // namespace tencer::python
