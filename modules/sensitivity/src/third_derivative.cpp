#include <algorithm>
#include <tencer/der/energy.hpp>
#include <tencer/sensitivity/parameters.hpp>

#include "cable_at.hpp"

namespace tencer::sensitivity {
namespace {

using equilibrium::System;
using model::State;

// The derivative along y of one rod's Hessian; numbers are those of the rod's own unknowns.
struct RodDirection {
  const System& system;
  const State& state;
  int number;  // of the rod
  const der::Rod& rod = system.structure().rods[number];
  int size = der::unknowns(rod);
  Eigen::VectorXd y{};

  Eigen::VectorXd own(const Eigen::Ref<const Eigen::VectorXd>& v) const {
    Eigen::VectorXd result(size);
    for (int i = 0; i < size; ++i) {
      const int at = system.index(number, i);
      result[i] = at >= 0 ? v[at] : 0.0;
    }
    return result;
  }
  Eigen::VectorXd times(const Eigen::VectorXd& v) const {
    return der::third_derivative(rod, state[number], y, v);
  }
};

void add_product(const RodDirection& at, const Eigen::Ref<const Eigen::VectorXd>& v,
                 Eigen::Ref<Eigen::VectorXd> result) {
  const Eigen::VectorXd product = at.times(at.own(v));
  for (int i = 0; i < at.size; ++i)
    if (const int row = at.system.index(at.number, i); row >= 0) result[row] += product[i];
}

// Which entries of a rod's Hessian are not zero, and groups of columns that share no row.
struct Columns {
  int moment = -1;  // the unknown that couples with everything, left out of what follows
  std::vector<std::vector<int>> rows{};
  std::vector<int> group{};
  int groups = 0;
};

Columns columns_of(const der::Rod& rod) {
  const int size = der::unknowns(rod);
  Columns columns{.rows = std::vector<std::vector<int>>(size), .group = std::vector<int>(size, -1)};
  if (der::twist_model(rod) == der::TwistModel::uniform) columns.moment = size - 1;
  for (const auto& element : der::elements(rod))
    for (const int j : element)
      for (const int i : element)
        if (i != columns.moment && j != columns.moment) columns.rows[j].push_back(i);
  for (auto& rows : columns.rows) {
    std::ranges::sort(rows);
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  }
  std::vector<int> taken_by(size, -1);  // per group the last column that may not join it
  for (int j = 0; j < size; ++j) {
    if (j == columns.moment) continue;
    for (const int row : columns.rows[j])
      for (const int other : columns.rows[row])
        if (columns.group[other] >= 0) taken_by[columns.group[other]] = j;
    int& group = columns.group[j];
    for (group = 0; taken_by[group] == j;) ++group;
    columns.groups = std::max(columns.groups, group + 1);
  }
  return columns;
}

// The matrix itself, in free unknowns: one product gives all columns of a group.
Eigen::SparseMatrix<double> assembled(const RodDirection& at) {
  const Columns columns = columns_of(at.rod);
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](int i, int j, double value) {
    const int row = at.system.index(at.number, i);
    const int column = at.system.index(at.number, j);
    if (row >= 0 && column >= 0) entries.emplace_back(row, column, value);
  };
  for (int group = 0; group < columns.groups; ++group) {
    Eigen::VectorXd probe = Eigen::VectorXd::Zero(at.size);
    for (int j = 0; j < at.size; ++j)
      if (columns.group[j] == group) probe[j] = 1;
    const Eigen::VectorXd product = at.times(probe);
    for (int j = 0; j < at.size; ++j)
      if (columns.group[j] == group)
        for (const int i : columns.rows[j]) add(i, j, product[i]);
  }
  if (columns.moment >= 0) {
    const Eigen::VectorXd product = at.times(Eigen::VectorXd::Unit(at.size, columns.moment));
    for (int i = 0; i < at.size; ++i) {
      add(i, columns.moment, product[i]);
      if (i != columns.moment) add(columns.moment, i, product[i]);
    }
  }
  Eigen::SparseMatrix<double> matrix(at.system.size(), at.system.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

Eigen::MatrixXd third_derivative_times(const System& system, const State& state,
                                       const Eigen::VectorXd& y,
                                       const Eigen::Ref<const Eigen::MatrixXd>& v) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(v.rows(), v.cols());
  // The number of columns from which assembling costs less than a product for each: rods have 15 to
  // 30 groups.
  constexpr int many = 40;
  for (int r = 0; r < static_cast<int>(state.size()); ++r) {
    RodDirection rod{.system = system, .state = state, .number = r};
    rod.y = rod.own(y);
    if (v.cols() < many)
      for (Eigen::Index k = 0; k < v.cols(); ++k) add_product(rod, v.col(k), result.col(k));
    else
      result += assembled(rod) * v;
  }
  for (int c = 0; c < static_cast<int>(system.stencils().size()); ++c) {
    const CableAt at(system, state, c);
    Eigen::Matrix3d stiffness_rate;
    for (int axis = 0; axis < 3; ++axis)
      stiffness_rate.col(axis) =
          springs::respond(at.cable(), at.span(),
                           {.span_1 = at.moved(y), .span_2 = Eigen::Vector3d::Unit(axis)})
              .force_12;
    for (Eigen::Index k = 0; k < v.cols(); ++k) {
      const Eigen::Vector3d force = stiffness_rate * at.moved(v.col(k));
      system.for_each_unknown(at.stencil(), [&](int row, int axis, double weight) {
        result(row, k) += weight * force[axis];
      });
    }
  }
  return result;
}

}  // namespace tencer::sensitivity
