#include <algorithm>
#include <cmath>
#include <tencer/der/energy.hpp>
#include <tencer/equilibrium/rigid_modes.hpp>
#include <tencer/linalg/dense.hpp>

#include "forces.hpp"

namespace tencer::equilibrium {
namespace {

// The matrix that takes w to w x a.
Eigen::Matrix3d cross_with(const Eigen::Vector3d& a) {
  Eigen::Matrix3d matrix;
  matrix << 0, a.z(), -a.y(), -a.z(), 0, a.x(), a.y(), -a.x(), 0;
  return matrix;
}

// A rigid motion is (v, w): p moves by v + w x (p - centre) / radius. Both parts are lengths.
struct Frame {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 1.0;

  Eigen::Matrix<double, 3, 6> velocity(const Eigen::Vector3d& p) const {
    Eigen::Matrix<double, 3, 6> rows;
    rows.leftCols<3>().setIdentity();
    rows.rightCols<3>() = cross_with((p - centre) / radius);
    return rows;
  }
  // Rate at which a material frame with tangent t turns about t.
  Eigen::Matrix<double, 1, 6> spin(const Eigen::Vector3d& t) const {
    Eigen::Matrix<double, 1, 6> row = Eigen::Matrix<double, 1, 6>::Zero();
    row.tail<3>() = t.transpose() / radius;
    return row;
  }
};

Frame frame_of(const System& system, const model::State& state, int component) {
  Frame frame;
  int count = 0;
  for (std::size_t r = 0; r < state.size(); ++r)
    if (system.component_of_rod()[r] == component) {
      frame.centre += state[r].x.rowwise().sum();
      count += static_cast<int>(state[r].x.cols());
    }
  frame.centre /= count;
  double squared = 0;
  for (std::size_t r = 0; r < state.size(); ++r)
    if (system.component_of_rod()[r] == component)
      squared += (state[r].x.colwise() - frame.centre).squaredNorm();
  frame.radius = std::sqrt(squared / count);
  return frame;
}

// Up to six of them, a column each, on the stack.
using Motions = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;

// Columns: an orthonormal basis of {m : rows m = 0}, up to a relative tolerance.
Motions null_space(const Eigen::MatrixXd& rows) {
  constexpr double tolerance = 1e-9;
  if (rows.rows() == 0) return Motions::Identity(6, 6);
  return linalg::null_space(rows, tolerance);
}

// The rigid motions that the supports and loads of a component allow, 6 x k.
Motions allowed_motions(const System& system, const model::State& state, int component,
                        const Frame& frame) {
  const model::Structure& structure = system.structure();
  std::vector<Eigen::Matrix<double, 1, 6>> rows;
  const auto in_component = [&](int rod) { return system.component_of_rod()[rod] == component; };
  for (const model::Pin& pin : structure.pins)
    if (in_component(pin.rod))
      for (int axis = 0; axis < 3; ++axis)
        if (pin.axes[axis])
          rows.push_back(frame.velocity(state[pin.rod].x.col(pin.vertex)).row(axis));
  for (const auto& cable : structure.cables) {
    const auto* a = std::get_if<springs::AtAnchor>(&cable.a);
    const auto* b = std::get_if<springs::AtAnchor>(&cable.b);
    if (!a && !b) continue;
    const int rod = std::get<springs::OnRod>(a ? cable.b : cable.a).rod;
    if (!in_component(rod)) continue;
    const auto velocity = frame.velocity(structure.anchors.col(a ? a->anchor : b->anchor));
    for (int axis = 0; axis < 3; ++axis) rows.push_back(velocity.row(axis));
  }
  for (std::size_t r = 0; r < state.size(); ++r) {
    const auto& rod = structure.rods[r];
    if (!in_component(static_cast<int>(r)) || state[r].theta.size() == 0) continue;
    if (rod.clamp_start_frame) rows.push_back(frame.spin(state[r].frames.tangent.col(0)));
    if (rod.clamp_end_frame)
      rows.push_back(frame.spin(state[r].frames.tangent.col(rod.edges() - 1)));
  }
  // Turned by w, a force f on the rods no longer balances what does not turn with them: w x f = 0.
  const auto add_load = [&](int rod, const Eigen::Vector3d& force) {
    if (!in_component(rod) || force.isZero(0)) return;
    const Eigen::Matrix3d turned = cross_with(force.normalized());
    for (int axis = 0; axis < 3; ++axis) {
      auto& row = rows.emplace_back(Eigen::Matrix<double, 1, 6>::Zero());
      row.tail<3>() = turned.row(axis);
    }
  };
  for (const model::LineLoad& load : structure.line_loads)
    add_load(load.rod, load.force_per_length);
  for (const model::PointLoad& load : structure.point_loads) add_load(load.rod, load.force);
  if (structure.planar)
    for (int held : {2, 3, 4}) rows.push_back(Eigen::Matrix<double, 1, 6>::Unit(held));
  Eigen::MatrixXd stacked(static_cast<Eigen::Index>(rows.size()), 6);
  for (std::size_t i = 0; i < rows.size(); ++i) stacked.row(static_cast<Eigen::Index>(i)) = rows[i];
  return null_space(stacked);
}

// The displacement of every free unknown of the component under the motions (6 x k).
Eigen::MatrixXd displacements(const System& system, const model::State& state, int component,
                              const Frame& frame, const Motions& motions) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(system.size(), motions.cols());
  for (int r = 0; r < static_cast<int>(state.size()); ++r) {
    if (system.component_of_rod()[r] != component) continue;
    const auto& rod_state = state[r];
    for (int v = 0; v < rod_state.x.cols(); ++v) {
      const Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 6> moved =
          frame.velocity(rod_state.x.col(v)).lazyProduct(motions);
      for (int axis = 0; axis < 3; ++axis)
        if (const int at = system.position_index(r, v, axis); at >= 0)
          result.row(at) = moved.row(axis);
    }
    const int theta = 3 * static_cast<int>(rod_state.x.cols());
    for (int j = 0; j < rod_state.theta.size(); ++j)
      if (const int at = system.index(r, theta + j); at >= 0)
        result.row(at) = frame.spin(rod_state.frames.tangent.col(j)) * motions;
  }
  return result;
}

// Of directions of `scale`; smaller ones by so much are none (a straight rod does not move when it
// turns about itself).
linalg::Span orthonormal(const Eigen::MatrixXd& columns, double scale) {
  constexpr double tolerance = 1e-7;
  return linalg::span_of(columns, tolerance * scale);
}

}  // namespace

std::vector<RigidModes> rigid_modes(const System& system, const model::State& state) {
  std::vector<RigidModes> modes;
  const int components = static_cast<int>(system.stabilising_unknowns().size());
  for (int component = 0; component < components; ++component) {
    const Frame frame = frame_of(system, state, component);
    const Eigen::MatrixXd moved = displacements(system, state, component, frame,
                                                allowed_motions(system, state, component, frame));
    RigidModes& mode = modes.emplace_back();
    // A unit motion moves a vertex by about 1.
    const double scale = std::sqrt(moved.rows());
    linalg::Span all = orthonormal(moved, scale);
    mode.basis = std::move(all.basis);
    mode.steadiness = all.least / scale;
    const auto& unknowns = system.stabilising_unknowns()[component];
    const double share = static_cast<double>(unknowns.size()) / system.size();
    mode.stabilising = orthonormal(mode.basis(unknowns, Eigen::all), std::sqrt(share)).basis;
  }
  return modes;
}

void stabilise(const System& system, const std::vector<RigidModes>& modes,
               linalg::SymmetricMatrix& matrix) {
  const Eigen::VectorXd root = edge_stiffness(system).cwiseSqrt();
  for (std::size_t g = 0; g < modes.size(); ++g) {
    if (modes[g].stabilising.cols() == 0) continue;
    const Eigen::VectorXd scale = root(system.stabilising_unknowns()[g]);
    const Eigen::MatrixXd scaled = scale.asDiagonal() * modes[g].stabilising;
    system.add_stabilising(static_cast<int>(g), scaled * scaled.transpose(), matrix);
  }
}

bool holds_loads(const System& system, const std::vector<RigidModes>& modes) {
  constexpr double tolerance = 1e-9;
  const Eigen::VectorXd& load = system.load_gradient();
  if (load.size() == 0) return true;
  for (const auto& mode : modes)
    if (!((mode.basis.transpose() * load).norm() <= tolerance * load.norm())) return false;
  return true;
}

void remove_rigid(const std::vector<RigidModes>& modes, Eigen::Ref<Eigen::VectorXd> v) {
  for (const auto& mode : modes) v -= mode.basis * (mode.basis.transpose() * v);
}

double steadiness(const std::vector<RigidModes>& modes) {
  double least = 1.0;
  for (const auto& mode : modes) least = std::min(least, mode.steadiness);
  return least;
}

int floating_components(const std::vector<RigidModes>& modes) {
  return static_cast<int>(
      std::ranges::count_if(modes, [](const auto& mode) { return mode.basis.cols() > 0; }));
}

}  // namespace tencer::equilibrium
