#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/ground_structure/pin_cables.hpp>
#include <tencer/network/rest_length.hpp>
#include <tencer/network/stage_recorder.hpp>
#include <tencer/springs/law.hpp>
#include <tencer/symmetry/orbit.hpp>
#include <utility>

namespace tencer::ground_structure {
namespace {

// Tensions and forces below this, relative to what they are part of, are none.
constexpr double negligible = 1e-6;

// Pulls along the columns of `directions` that sum to `force`, and how good they are: the least
// change of the force, relative to it, that leaves one without tension, over the sum of tensions.
struct Split {
  Eigen::VectorXd tensions{};
  double merit = -1.0;
};

Split split_along(const Eigen::MatrixXd& directions, const Eigen::VectorXd& force) {
  const Eigen::FullPivLU<Eigen::MatrixXd> factor(directions);
  if (!factor.isInvertible()) return {};
  const Eigen::MatrixXd inverse = factor.inverse();
  const Eigen::VectorXd tensions = inverse * force;
  const double total = tensions.cwiseAbs().sum();
  if (!(tensions.minCoeff() >= -1e-9 * total)) return {};
  const Eigen::VectorXd change = tensions.array() / inverse.rowwise().norm().array();
  return {.tensions = tensions, .merit = std::max(0.0, change.minCoeff()) / total};
}

struct PinCable {
  springs::OnRod place;
  int anchor = 0;
  double tension = 0.0;
};

bool same_place(const springs::OnRod& a, const springs::OnRod& b,
                const std::vector<geometry::ArcLength>& rods) {
  if (a.rod != b.rod) return false;
  const auto& rod = rods[a.rod];
  const double apart =
      rod.closed() ? std::remainder(a.s - b.s, rod.length()) : rod.wrap(a.s) - rod.wrap(b.s);
  return std::abs(apart) <= 10 * symmetry::same_place * rod.length();
}

void add(std::vector<PinCable>& cables, const PinCable& cable,
         const std::vector<geometry::ArcLength>& rods) {
  const auto known = std::ranges::find_if(cables, [&](const PinCable& other) {
    return other.anchor == cable.anchor && same_place(other.place, cable.place, rods);
  });
  if (known == cables.end())
    cables.push_back(cable);
  else
    known->tension += cable.tension;
}

// By rod and vertex; several pins of a vertex hold it together.
std::map<std::pair<int, int>, Eigen::Vector3d> forces_on_vertices(const model::Structure& structure,
                                                                  const model::State& state) {
  const Eigen::Matrix3Xd forces = pin_forces(structure, state);
  std::map<std::pair<int, int>, Eigen::Vector3d> result;
  for (std::size_t p = 0; p < structure.pins.size(); ++p) {
    const auto& pin = structure.pins[p];
    auto& sum = result.try_emplace({pin.rod, pin.vertex}, Eigen::Vector3d::Zero()).first->second;
    for (int axis = 0; axis < 3; ++axis)
      if (pin.axes[axis]) sum[axis] = forces(axis, static_cast<Eigen::Index>(p));
  }
  return result;
}

// All cables in place of the pins. With a symmetry the cables of one pin are copied to those it is
// mapped to; operations that keep the pin share its force among the images of its cables.
std::vector<PinCable> pin_cables(const network::Network& pinned, const symmetry::Group* symmetry,
                                 double max_length) {
  const auto& structure = pinned.structure;
  const auto rods = model::arc_lengths(structure);
  const auto forces = forces_on_vertices(structure, pinned.state);
  double typical = 1.0;
  for (const auto& [vertex, force] : forces) typical = std::max(typical, force.norm());
  std::vector<symmetry::Operation> operations{symmetry::identity(
      static_cast<int>(rods.size()), static_cast<int>(structure.anchors.cols()))};
  if (symmetry) operations = symmetry->operations;
  std::vector<PinCable> cables;
  std::vector<springs::OnRod> done;
  for (const auto& [at, force] : forces) {
    const auto [rod, vertex] = at;
    const springs::OnRod place{rod, rods[rod].knots()[vertex]};
    const bool known = std::ranges::any_of(
        done, [&](const springs::OnRod& other) { return same_place(place, other, rods); });
    if (known || force.norm() <= negligible * typical) continue;
    const AnchorPull held = anchor_pull(pinned.state[rod].x.col(vertex), force, structure.anchors,
                                        structure.planar, max_length);
    const auto image_of = [&](const symmetry::Operation& operation) {
      return std::get<springs::OnRod>(symmetry::image(operation, springs::End{place}, rods));
    };
    const auto keeping = std::ranges::count_if(operations, [&](const auto& operation) {
      return same_place(image_of(operation), place, rods);
    });
    for (const auto& operation : operations) {
      done.push_back(image_of(operation));
      for (std::size_t i = 0; i < held.anchors.size(); ++i)
        add(cables,
            {done.back(), operation.anchors[held.anchors[i]],
             held.tensions[static_cast<Eigen::Index>(i)] / static_cast<double>(keeping)},
            rods);
    }
  }
  return cables;
}

}  // namespace

Eigen::Matrix3Xd pin_forces(const model::Structure& structure, const model::State& state) {
  model::Structure released = structure;
  released.pins.clear();
  const equilibrium::System system(released);
  const Eigen::VectorXd gradient = system.gradient(state);
  Eigen::Matrix3Xd forces =
      Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(structure.pins.size()));
  for (std::size_t p = 0; p < structure.pins.size(); ++p) {
    const auto& pin = structure.pins[p];
    for (int axis = 0; axis < 3; ++axis)
      if (const int i = system.position_index(pin.rod, pin.vertex, axis); pin.axes[axis] && i >= 0)
        forces(axis, static_cast<Eigen::Index>(p)) = gradient[i];
  }
  return forces;
}

AnchorPull anchor_pull(const Eigen::Vector3d& point, const Eigen::Vector3d& force,
                       const Eigen::Matrix3Xd& anchors, bool planar, double max_length) {
  if (force.isZero(0)) return {};
  const int dimension = planar ? 2 : 3;
  const Eigen::Matrix3Xd spans = anchors.colwise() - point;
  std::vector<int> near;
  for (Eigen::Index i = 0; i < spans.cols(); ++i)
    if (const double length = spans.col(i).norm(); length > 0 && length <= max_length)
      near.push_back(static_cast<int>(i));
  const int n = static_cast<int>(near.size());
  Split best;
  std::vector<int> chosen;
  const auto consider = [&](std::vector<int> trial) {
    Eigen::MatrixXd directions(dimension, dimension);
    for (int k = 0; k < dimension; ++k)
      directions.col(k) = spans.col(trial[k]).normalized().head(dimension);
    Split split = split_along(directions, force.head(dimension));
    if (split.merit < 0) return;
    // The first of equals stays: rounding must not choose.
    if (!chosen.empty() && split.merit <= best.merit * (1 + 1e-9)) return;
    best = std::move(split);
    chosen = std::move(trial);
  };
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j) {
      if (planar) consider({near[i], near[j]});
      for (int k = j + 1; k < n && !planar; ++k) consider({near[i], near[j], near[k]});
    }
  core::require(!chosen.empty(), "anchor_pull: the anchors must surround the point");
  AnchorPull result;
  std::vector<double> tensions;
  for (int k = 0; k < dimension; ++k) {
    if (best.tensions[k] <= negligible * force.norm()) continue;
    result.anchors.push_back(chosen[k]);
    tensions.push_back(best.tensions[k]);
  }
  result.tensions = Eigen::Map<Eigen::VectorXd>(tensions.data(), std::ssize(tensions));
  return result;
}

network::StageResult replace_pins(const network::Network& pinned, const Problem& problem,
                                  const network::Control& control) {
  network::StageRecorder recorder("hand-over", control);
  network::StageResult result{.network = pinned};
  auto& [structure, state] = result.network;
  const auto cables = pin_cables(pinned, problem.group(), problem.rules.max_cable_length);
  structure.pins.clear();
  const auto along = model::arc_lengths(structure);
  for (const PinCable& cable : cables) {
    const springs::Cable slack{.a = cable.place, .b = springs::AtAnchor{cable.anchor}};
    const auto stencil = springs::stencil(slack, along, structure.anchors);
    structure.cables.push_back(springs::with_tension(slack, model::span_of(stencil, state).norm(),
                                                     cable.tension, network::stiff_rest_ratio));
  }
  equilibrium::SolveOptions solve = control.solve;
  solve.stop = control.stop;
  auto solved = equilibrium::solve(equilibrium::System(structure), state, solve);
  state = std::move(solved.state);
  recorder.add({.solves = 1, .iterations = solved.iterations});
  result.trace.push_back(
      recorder.row(result.network, problem.target,
                   solved.usable() ? "" : "without pins: " + equilibrium::describe(solved.reason)));
  recorder.finish(result, problem.target);
  return result;
}

}  // namespace tencer::ground_structure
