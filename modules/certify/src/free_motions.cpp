#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <tencer/certify/free_motions.hpp>
#include <tencer/core/names.hpp>
#include <tencer/equilibrium/rigid_modes.hpp>
#include <tencer/linalg/dense.hpp>

namespace tencer::certify {
namespace {

using equilibrium::System;

constexpr double negligible = 1e-6;

Eigen::Vector3d centre_of(const model::State& state, const std::vector<int>& rods) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Index count = 0;
  for (const int r : rods) {
    sum += state[r].x.rowwise().sum();
    count += state[r].x.cols();
  }
  return sum / static_cast<double>(count);
}

double reach_of(const model::State& state, const std::vector<int>& rods,
                const Eigen::Vector3d& centre) {
  double reach = 0;
  for (const int r : rods)
    reach = std::max(reach, (state[r].x.colwise() - centre).colwise().norm().maxCoeff());
  return reach;
}

// The velocity (first three) and spin times reach (last three) about `centre` of each column of
// displacements: the rigid motion nearest to it, of least size where a straight rod leaves its spin
// open.
Eigen::MatrixXd twists(const System& system, const model::State& state,
                       const std::vector<int>& rods, const Eigen::Vector3d& centre, double reach,
                       const Eigen::MatrixXd& basis) {
  std::vector<int> unknowns;
  std::vector<Eigen::Matrix<double, 1, 6>> rows;
  for (const int r : rods)
    for (int v = 0; v < state[r].x.cols(); ++v) {
      const Eigen::Vector3d arm = (state[r].x.col(v) - centre) / reach;
      Eigen::Matrix<double, 3, 6> velocity;
      velocity << Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero();
      for (int axis = 0; axis < 3; ++axis)
        velocity.col(3 + axis) = Eigen::Vector3d::Unit(axis).cross(arm);
      for (int axis = 0; axis < 3; ++axis) {
        const int at = system.position_index(r, v, axis);
        unknowns.push_back(at);
        rows.push_back(velocity.row(axis));
      }
    }
  Eigen::MatrixXd motions(static_cast<Eigen::Index>(rows.size()), 6);
  Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(motions.rows(), basis.cols());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    motions.row(row) = rows[i];
    if (unknowns[i] >= 0) moved.row(row) = basis.row(unknowns[i]);
  }
  return linalg::least_squares(motions, moved, negligible);
}

// Turns first, then shifts: columns (velocity, spin) of a basis made so that as many as can be have
// no spin.
std::vector<RigidMotion> named_motions(const Eigen::MatrixXd& twists, const Eigen::Vector3d& centre,
                                       double reach) {
  const Eigen::MatrixXd spins = twists.bottomRows(3);
  const Eigen::MatrixXd by_spin = linalg::symmetric_eigenpairs(spins.transpose() * spins).vectors;
  const double largest = twists.cwiseAbs().maxCoeff();
  const Eigen::MatrixXd sorted = twists * by_spin.rowwise().reverse();
  std::vector<RigidMotion> motions;
  for (const auto& twist : sorted.colwise()) {
    const Eigen::Vector3d velocity = twist.head(3);
    const Eigen::Vector3d spin = twist.tail(3) / reach;
    RigidMotion& motion = motions.emplace_back();
    motion.turns = twist.tail(3).norm() > negligible * largest;
    motion.direction = (motion.turns ? spin : velocity).normalized();
    if (motion.turns) motion.point = centre + spin.cross(velocity) / spin.squaredNorm();
  }
  return motions;
}

bool is_held(const model::Structure& structure, const std::vector<int>& rods) {
  const auto ours = [&](int rod) { return std::ranges::find(rods, rod) != rods.end(); };
  const auto hangs = [&](const springs::Cable& cable) {
    const auto* a = std::get_if<springs::OnRod>(&cable.a);
    const auto* b = std::get_if<springs::OnRod>(&cable.b);
    return model::is_external(cable) && ours(a ? a->rod : b->rod);
  };
  const auto on_ours = [&](const auto& held) { return ours(held.rod); };
  return std::ranges::any_of(structure.pins, on_ours) ||
         std::ranges::any_of(structure.point_loads, on_ours) ||
         std::ranges::any_of(structure.line_loads, on_ours) ||
         std::ranges::any_of(structure.cables, hangs);
}

std::string vector_text(const Eigen::Vector3d& v) {
  std::ostringstream text;
  text.precision(3);
  text << '(';
  for (int axis = 0; axis < 3; ++axis)
    text << (axis > 0 ? ", " : "") << (std::abs(v[axis]) < 1e-9 ? 0.0 : v[axis]);
  text << ')';
  return text.str();
}

}  // namespace

std::vector<FreeGroup> free_groups(const model::Structure& structure, const model::State& state) {
  const System system(structure);
  const std::vector<equilibrium::RigidModes> modes = equilibrium::rigid_modes(system, state);
  std::vector<FreeGroup> groups;
  for (int g = 0; g < static_cast<int>(modes.size()); ++g) {
    const Eigen::MatrixXd& basis = modes[g].basis;
    if (basis.cols() == 0) continue;
    FreeGroup group;
    for (int r = 0; r < static_cast<int>(structure.rods.size()); ++r)
      if (system.component_of_rod()[r] == g) group.rods.push_back(r);
    group.held = is_held(structure, group.rods);
    if (group.held) {
      const Eigen::Vector3d centre = centre_of(state, group.rods);
      const double reach = reach_of(state, group.rods, centre);
      group.motions =
          named_motions(twists(system, state, group.rods, centre, reach, basis), centre, reach);
    }
    groups.push_back(std::move(group));
  }
  if (modes.size() == 1 && groups.size() == 1 && !groups[0].held) return {};
  return groups;
}

std::string describe(const FreeGroup& group, std::size_t rods) {
  std::string text = core::rods_in_words(group.rods, rods);
  const bool one = group.rods.size() == 1;
  if (!group.held) return text + (one ? " moves freely" : " move freely");
  for (std::size_t i = 0; i < group.motions.size(); ++i) {
    const RigidMotion& motion = group.motions[i];
    text += i > 0 ? ", and" : "";
    if (motion.turns)
      text += std::string(one ? " turns" : " turn") + " about the line through " +
              vector_text(motion.point) + " along " + vector_text(motion.direction);
    else
      text += std::string(one ? " shifts" : " shift") + " along " + vector_text(motion.direction);
  }
  return text;
}

}  // namespace tencer::certify
