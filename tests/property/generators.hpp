// Random curves, rods and structures for the property tests; what rapidcheck shrinks is the numbers
// they are made of.
#pragma once

#include <rapidcheck/catch.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <tencer/equilibrium/stability.hpp>
#include <vector>

namespace tencer::property {

// In [low, high], shrinking towards low.
inline double number(double low, double high) {
  constexpr int steps = 1 << 20;
  return low + (high - low) * *rc::gen::noShrink(rc::gen::inRange(0, steps + 1)) / steps;
}

// From `low` to `high`, both included.
inline int whole(int low, int high) { return *rc::gen::inRange(low, high + 1); }

inline bool coin() { return *rc::gen::arbitrary<bool>(); }

inline Eigen::VectorXd numbers(Eigen::Index count, double low, double high) {
  Eigen::VectorXd result(count);
  for (double& entry : result) entry = number(low, high);
  return result;
}

inline Eigen::Matrix3Xd vectors(Eigen::Index count, double size) {
  return numbers(3 * count, -size, size).reshaped(3, count);
}

inline Eigen::Matrix3d rotation() {
  const Eigen::Vector3d axis = vectors(1, 1);
  return Eigen::AngleAxisd(number(0, 6), (axis + Eigen::Vector3d(0, 0, 1e-3)).normalized())
      .toRotationMatrix();
}

enum class Pose {
  generic,
  straight,      // open rods; closed ones are then regular polygons in a plane
  nearly_folded  // one vertex turned by all but a hundredth of half a turn
};

inline Pose pose() { return *rc::gen::element(Pose::generic, Pose::straight, Pose::nearly_folded); }

// A curve with edges about as long as `lengths`.
inline Eigen::Matrix3Xd curve(const Eigen::VectorXd& lengths, bool closed, Pose pose) {
  const Eigen::Index n = lengths.size() + (closed ? 0 : 1);
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, n);
  if (closed) {
    const double radius = lengths.sum() / (2 * std::numbers::pi);
    for (Eigen::Index i = 0; i < n; ++i) {
      const double phi = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
      x.col(i) = radius * Eigen::Vector3d(std::cos(phi), std::sin(phi), 0);
    }
  } else {
    for (Eigen::Index i = 1; i < n; ++i)
      x.col(i) = x.col(i - 1) + Eigen::Vector3d(lengths[i - 1], 0, 0);
  }
  if (pose == Pose::straight) return x;
  x += vectors(n, 0.2 * lengths.minCoeff());
  if (pose == Pose::nearly_folded) {
    const int at = whole(1, static_cast<int>(n) - 2);
    const Eigen::Vector3d back = x.col(at - 1) - x.col(at);
    const Eigen::Vector3d aside = back.unitOrthogonal() * back.norm();
    const double gap = std::numbers::pi / 100;
    const Eigen::Vector3d edge = std::cos(gap) * back + std::sin(gap) * aside;
    const Eigen::Vector3d shift = x.col(at) + edge - x.col(at + 1);
    for (Eigen::Index i = at + 1; i < n; ++i) x.col(i) += shift;
  }
  return x;
}

// What a rod may be: each a different set of unknowns and terms.
enum class RodKind { plain, uniform_twist, strip };

struct RodWish {
  bool closed = false;
  RodKind kind = RodKind::plain;
};

inline RodWish rod_wish() {
  const bool closed = coin();
  const RodKind kind = *rc::gen::element(RodKind::plain, RodKind::uniform_twist, RodKind::strip);
  return {closed, kind == RodKind::uniform_twist && !closed ? RodKind::plain : kind};
}

// Rods that do not depend on where they start and which way they run.
inline RodWish alike_all_along() {
  const bool closed = coin();
  return {closed, closed && coin() ? RodKind::uniform_twist : RodKind::plain};
}

inline der::Rod rod(const RodWish& wish) {
  const int edges = whole(wish.closed ? 5 : 3, 10);
  der::Rod result{.closed = wish.closed,
                  .section = {.EA = number(20, 200), .EI1 = number(0.5, 2), .GJ = number(0.3, 1)},
                  .rest_lengths = numbers(edges, 0.6, 1.4)};
  result.section.EI2 = result.section.EI1;
  if (wish.kind == RodKind::uniform_twist) {
    result.closing_angle = number(-3, 3);
    result.rest_twist = numbers(result.bending_vertices(), -0.3, 0.3);
  }
  if (wish.kind == RodKind::strip) {
    result.section.EI2 = number(0.5, 2) * result.section.EI1 + 1e-3;
    result.rest_curvature =
        numbers(2 * result.bending_vertices(), -0.4, 0.4).reshaped(2, result.bending_vertices());
    result.rest_twist = numbers(result.bending_vertices(), -0.3, 0.3);
    if (wish.closed && coin()) result.closing_angle = number(-3, 3);
  }
  return result;
}

// A place on a rod: anywhere, on a vertex exactly, on the seam, or several turns away.
inline springs::OnRod place(const std::vector<der::Rod>& rods) {
  const int r = whole(0, static_cast<int>(rods.size()) - 1);
  const Eigen::VectorXd& lengths = rods[r].rest_lengths;
  const auto edges = static_cast<int>(lengths.size());
  switch (whole(0, 3)) {
    case 0:
      return {r, geometry::ArcLength(lengths, rods[r].closed).knots()[whole(0, edges)]};
    case 1:
      return {r, 0.0};
    case 2:
      return {r, number(-3, 3) * lengths.sum()};
    default:
      return {r, number(0, 1) * lengths.sum()};
  }
}

inline springs::Cable cable(const model::Structure& structure) {
  springs::Cable result{.a = place(structure.rods),
                        .b = place(structure.rods),
                        .stiffness = number(0.1, 20),
                        .rest_length = number(0, 1),
                        .tension_only = coin()};
  if (structure.anchors.cols() > 0 && whole(0, 3) == 0)
    result.b = springs::AtAnchor{whole(0, static_cast<int>(structure.anchors.cols()) - 1)};
  if (whole(0, 7) == 0) result.b = result.a;
  return result;
}

struct Posed {
  model::Structure structure;
  std::vector<Eigen::Matrix3Xd> x;

  model::State state() const { return model::make_state(structure, x); }
};

// Up to three rods of the kinds wished for, each in a pose of its own, with cables.
template <class Wish>
Posed posed(Wish&& wish) {
  Posed result;
  const int rods = whole(1, 3);
  for (int r = 0; r < rods; ++r) {
    result.structure.rods.push_back(rod(wish()));
    const der::Rod& made = result.structure.rods.back();
    Eigen::Matrix3Xd x = curve(made.rest_lengths, made.closed, pose());
    x.colwise() += Eigen::Vector3d(0.3 * r, -0.2 * r, 0.7 * r);
    result.x.push_back(rotation() * x);
  }
  result.structure.anchors = vectors(whole(0, 3), 3);
  for (int c = whole(0, 6); c > 0; --c) result.structure.cables.push_back(cable(result.structure));
  // A cable without length has no direction to push in, so it must have no rest length either.
  const equilibrium::System system(result.structure);
  const model::State state = result.state();
  for (std::size_t c = 0; c < result.structure.cables.size(); ++c)
    if (model::span_of(system.stencils()[c], state).norm() < 1e-6)
      result.structure.cables[c].rest_length = 0;
  return result;
}

// One or two rings that cables pull well off the circle, in equilibrium; discards what does not
// come to rest or is close to losing its stability. All cables pull.
struct Held {
  Posed posed;  // at the equilibrium
  double eigenvalue = 0.0;
};

inline Held held() {
  Posed a;
  const int rods = whole(1, 2);
  for (int r = 0; r < rods; ++r) {
    a.structure.rods.push_back(
        rod({.closed = true, .kind = coin() ? RodKind::uniform_twist : RodKind::plain}));
    const der::Rod& made = a.structure.rods.back();
    Eigen::Matrix3Xd x = curve(made.rest_lengths, true, Pose::generic);
    if (r == 1) x = (rotation() * x).colwise() + Eigen::Vector3d(0.6, 0.2, 0.1);
    a.x.push_back(x);
  }
  const auto on = [&](int r) {
    return springs::OnRod{r, number(0, 1) * a.structure.rods[r].length()};
  };
  for (int c = whole(3 * rods, 6 * rods); c > 0; --c)
    a.structure.cables.push_back({.a = on(0),
                                  .b = on(rods - 1),
                                  .stiffness = number(0.005, 0.05),
                                  .rest_length = 0,
                                  .tension_only = coin()});
  const equilibrium::System system(a.structure);
  const auto found = equilibrium::solve(system, a.state());
  RC_PRE(found.usable());
  for (std::size_t r = 0; r < a.x.size(); ++r) a.x[r] = found.state[r].x;
  const auto certificate = equilibrium::stability(system, found.state);
  RC_PRE(certificate.stable() && certificate.smallest_eigenvalue > 50);
  for (const springs::Stencil& stencil : system.stencils())
    RC_PRE(model::span_of(stencil, found.state).norm() > 0.05);
  return {a, certificate.smallest_eigenvalue};
}

inline double largest(const Eigen::MatrixXd& m) {
  return m.size() > 0 ? m.cwiseAbs().maxCoeff() : 0;
}

}  // namespace tencer::property
