// Small structures of any kind to equilibrium: the solve ends, says how, never returns what is not
// a number, and what it calls an equilibrium is one.
#include <stdexcept>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/stability.hpp>

#include "bytes.hpp"
#include "must.hpp"

using namespace tencer;
using namespace tencer::equilibrium;
using fuzz::Bytes;
using fuzz::must;

namespace {

der::Rod rod_of(Bytes& bytes) {
  der::Rod rod;
  const std::uint8_t kind = bytes.byte();
  rod.closed = (kind & 1) != 0;
  const int edges = (rod.closed ? 3 : 2) + bytes.below_or(7);
  rod.section.EA = bytes.scale(20);
  rod.section.EI1 = bytes.scale(10);
  rod.section.EI2 = (kind & 2) != 0 ? bytes.scale(10) : rod.section.EI1;
  rod.section.GJ = bytes.scale(10);
  rod.rest_lengths.resize(edges);
  for (double& length : rod.rest_lengths) length = bytes.scale(4) * (1.5 + 0.5 * bytes.share());
  if ((kind & 4) != 0) {
    rod.rest_curvature.resize(2, rod.bending_vertices());
    for (double& bend : rod.rest_curvature.reshaped()) bend = 2 * bytes.share();
  }
  if ((kind & 8) != 0) {
    rod.rest_twist.resize(rod.bending_vertices());
    for (double& twist : rod.rest_twist) twist = 3 * bytes.share();
  }
  if (rod.closed && (kind & 16) != 0) rod.closing_angle = 20 * bytes.share();
  return rod;
}

springs::End end_of(Bytes& bytes, const model::Structure& structure) {
  const std::uint8_t kind = bytes.byte();
  const auto anchors = static_cast<int>(structure.anchors.cols());
  if ((kind & 1) != 0 && anchors > 0) return springs::AtAnchor{bytes.below_or(anchors - 1)};
  const int rod = bytes.below_or(static_cast<int>(structure.rods.size()) - 1);
  const Eigen::VectorXd& lengths = structure.rods[rod].rest_lengths;
  // On a vertex exactly, or anywhere.
  if ((kind & 2) != 0)
    return springs::OnRod{rod,
                          lengths.head(bytes.below_or(static_cast<int>(lengths.size()))).sum()};
  return springs::OnRod{rod, 2 * bytes.share() * lengths.sum()};
}

Eigen::Vector3d vector_of(Bytes& bytes) {
  const double x = bytes.share(), y = bytes.share(), z = bytes.share();
  return {x, y, z};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  model::Structure structure;
  std::vector<Eigen::Matrix3Xd> start;
  const std::uint8_t kind = bytes.byte();
  structure.planar = (kind & 1) != 0;
  const double extent = bytes.scale(5);
  const int rods = 1 + bytes.below_or(2);
  for (int r = 0; r < rods; ++r) {
    structure.rods.push_back(rod_of(bytes));
    Eigen::Matrix3Xd x(3, structure.rods.back().vertices());
    for (int i = 0; i < x.cols(); ++i) x.col(i) = extent * vector_of(bytes);
    if (structure.planar) x.row(2).setZero();
    start.push_back(x);
  }
  structure.anchors.resize(3, bytes.below_or(3));
  for (int i = 0; i < structure.anchors.cols(); ++i)
    structure.anchors.col(i) = extent * vector_of(bytes);
  for (int i = bytes.below_or(5); i > 0; --i) {
    const springs::End a = end_of(bytes, structure), b = end_of(bytes, structure);
    structure.cables.push_back({.a = a,
                                .b = b,
                                .stiffness = bytes.scale(20),
                                .rest_length = extent * std::abs(bytes.share()),
                                .tension_only = bytes.flag()});
  }
  for (int i = bytes.below_or(2); i > 0; --i) {
    const int rod = bytes.below_or(rods - 1);
    const int vertex = bytes.below_or(structure.rods[rod].vertices() - 1);
    const std::uint8_t axes = bytes.byte();
    structure.pins.push_back({rod, vertex, {(axes & 1) != 0, (axes & 2) != 0, (axes & 4) != 0}});
  }
  if ((kind & 2) != 0)
    structure.point_loads.push_back({.rod = bytes.below_or(rods - 1),
                                     .s = bytes.share(),
                                     .force = bytes.scale(10) * vector_of(bytes)});
  if ((kind & 4) != 0)
    structure.line_loads.push_back(
        {.rod = bytes.below_or(rods - 1), .force_per_length = bytes.scale(10) * vector_of(bytes)});
  model::State state;
  try {
    validate(structure);
    state = model::make_state(structure, start);
  } catch (const std::invalid_argument&) {
    return 0;  // a caller's mistake, told as such
  }

  const System system(structure);
  const double before = system.energy(state);
  Linearisation at;
  const Equilibrium found = solve(system, state, {.max_iterations = 100}, at);
  must(!describe(found.reason).empty());
  must(found.iterations <= 100);
  if (std::isfinite(before)) {
    for (const der::RodState& rod : found.state) must(rod.x.allFinite());
    must(!(found.energy > before + 1e-9 * std::abs(before)));
  }
  if (!found.usable()) return 0;
  must(std::isfinite(found.energy) && std::isfinite(found.residual));
  must(found.negative == 0);
  // Nothing is left to do.
  const Equilibrium again = solve(system, found.state, {.max_iterations = 100});
  double scale = std::abs(found.energy);
  for (const der::Rod& rod : structure.rods)
    scale += rod.section.EA * rod.length() +
             std::max({rod.section.EI1, rod.section.EI2, rod.section.GJ}) / rod.length();
  must(std::abs(again.energy - found.energy) <= 1e-9 * scale);
  const Stability certificate = stability(system, found.state);
  must(!certificate.computed || std::isfinite(certificate.smallest_eigenvalue));
  must(certificate.negative == 0 || !certificate.stable());
  return 0;
}
