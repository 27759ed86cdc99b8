// Matrices of points as arrays and back. Points are columns in C++ and rows in Python: the same
// numbers in the same order, so that neither way needs a copy.
#pragma once

#include <tencer/core/error.hpp>
#include <vector>

#include "bind.hpp"

namespace tencer::python {

// What a caller gives: an array of any kind of number, copied only if it is not one of doubles in
// rows already.
using Given = py::array_t<double, py::array::c_style | py::array::forcecast>;

inline void read_only(py::array& array) {
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
}

// Read-only views of what `owner` holds: (n, 3) and (n).
inline py::array view(const Eigen::Matrix3Xd& points, py::handle owner) {
  py::array_t<double> array({points.cols(), Eigen::Index{3}}, points.data(), owner);
  read_only(array);
  return array;
}

inline py::array view(const Eigen::VectorXd& numbers, py::handle owner) {
  py::array_t<double> array(numbers.size(), numbers.data(), owner);
  read_only(array);
  return array;
}

inline std::vector<py::array> views(const std::vector<Eigen::Matrix3Xd>& list, py::handle owner) {
  std::vector<py::array> arrays;
  for (const Eigen::Matrix3Xd& points : list) arrays.push_back(view(points, owner));
  return arrays;
}

// An (n, 3) array as 3 x n; throws std::invalid_argument, which names it, for another shape.
inline Eigen::Map<const Eigen::Matrix3Xd> points_of(const Given& array, const std::string& name) {
  if (array.ndim() != 2 || array.shape(1) != 3) {
    std::string shape;
    for (py::ssize_t i = 0; i < array.ndim(); ++i)
      shape += (i ? ", " : "") + std::to_string(array.shape(i));
    throw std::invalid_argument(name + ": expected an array of shape (n, 3), found one of (" +
                                shape + ")");
  }
  return {array.data(), 3, array.shape(0)};
}

// A vector of numbers, (n); throws likewise.
inline Eigen::Map<const Eigen::VectorXd> numbers_of(const Given& array, const std::string& name) {
  if (array.ndim() != 1)
    throw std::invalid_argument(name + ": expected an array of shape (n), found one of " +
                                std::to_string(array.ndim()) + " dimensions");
  return {array.data(), array.shape(0)};
}

// Arrays of their own.
inline py::array owned(const Eigen::VectorXd& numbers) {
  return py::array_t<double>(numbers.size(), numbers.data());
}
inline py::array owned(const Eigen::Matrix3Xd& points) {
  return py::array_t<double>({points.cols(), Eigen::Index{3}}, points.data());
}

// An array of its own, made of rows.
template <class Row>
py::array_t<Row> table(const std::vector<Row>& rows) {
  return py::array_t<Row>(static_cast<py::ssize_t>(rows.size()), rows.data());
}

}  // namespace tencer::python
