// Rods of every twist model in generic poses, and dense derivatives of theirs.
#pragma once

#include <cmath>
#include <string>
#include <tencer/der/energy.hpp>
#include <vector>

namespace tencer::der {

// Rest curvature so small that it changes no digit, but keeps an angle per edge.
inline void force_per_edge(Rod& rod) {
  rod.rest_curvature = Eigen::Matrix2Xd::Constant(2, rod.bending_vertices(), 1e-300);
}

struct NamedRod {
  std::string name;
  Rod rod;
};

inline std::vector<NamedRod> rods_of_every_model(int vertices) {
  const auto make = [&](bool closed, double EI2) {
    const int edges = closed ? vertices : vertices - 1;
    return Rod{.closed = closed,
               .section = {.EA = 30.0, .EI1 = 1.3, .EI2 = EI2, .GJ = 0.9},
               .rest_lengths =
                   Eigen::VectorXd::Constant(edges, 1.0) + 0.3 * Eigen::VectorXd::Random(edges)};
  };
  const auto curve = [](Rod rod) {
    rod.rest_curvature = Eigen::Matrix2Xd::Random(2, rod.bending_vertices());
    rod.rest_twist = Eigen::VectorXd::Random(rod.bending_vertices());
    return rod;
  };
  std::vector<NamedRod> rods{{"open, no twist", make(false, 1.3)},
                             {"closed, no twist", make(true, 1.3)},
                             {"closed, uniform twist", make(true, 1.3)},
                             {"open strip, curved and twisted", curve(make(false, 0.4))},
                             {"closed strip, glued freely", curve(make(true, 0.4))},
                             {"closed strip with a closing angle", curve(make(true, 0.4))},
                             {"open, both ends clamped", make(false, 1.3)}};
  rods[2].rod.closing_angle = 2.5;
  rods[2].rod.rest_twist = Eigen::VectorXd::Random(vertices);
  rods[5].rod.closing_angle = -4.0;
  rods[6].rod.clamp_start_frame = rods[6].rod.clamp_end_frame = true;
  return rods;
}

inline RodState moved(const Rod& rod, RodState state, const Eigen::VectorXd& step) {
  displace(rod, state, step);
  return state;
}

// A bent curve without folds, off its rest lengths, with angles anywhere.
inline RodState random_state(const Rod& rod) {
  const int n = rod.vertices();
  Eigen::Matrix3Xd x(3, n);
  for (int i = 0; i < n; ++i) {
    const double phi = 2 * 3.14159265 * i / n;
    x.col(i) = 0.18 * n * Eigen::Vector3d(std::cos(phi), std::sin(phi), 0.3 * std::sin(2 * phi));
  }
  return moved(rod, make_state(rod, x), 0.1 * Eigen::VectorXd::Random(unknowns(rod)));
}

inline Eigen::VectorXd gradient(const Rod& rod, const RodState& state) {
  Eigen::VectorXd g = Eigen::VectorXd::Zero(unknowns(rod));
  add_gradient(rod, state, g);
  return g;
}

inline Eigen::MatrixXd dense_hessian(const Rod& rod, const RodState& state) {
  const auto lists = elements(rod);
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(unknowns(rod), unknowns(rod));
  hessian(rod, state, axial_forces(rod, state.x), [&](int element, const double* matrix) {
    const auto& list = lists[element];
    for (std::size_t b = 0; b < list.size(); ++b)
      for (std::size_t a = 0; a < list.size(); ++a)
        h(list[a], list[b]) += matrix[a + b * list.size()];
  });
  return h;
}

// With uniform twist, the Hessian of the energy itself: the moment eliminated.
inline Eigen::MatrixXd energy_hessian(const Rod& rod, const RodState& state) {
  const Eigen::MatrixXd h = dense_hessian(rod, state);
  if (twist_model(rod) != TwistModel::uniform) return h;
  const auto m = h.rows() - 1;
  return h.topLeftCorner(m, m) - h.topRightCorner(m, 1) * h.bottomLeftCorner(1, m) / h(m, m);
}

}  // namespace tencer::der
