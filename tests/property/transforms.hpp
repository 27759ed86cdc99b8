// The same structure put elsewhere, numbered otherwise or given in other units.
#pragma once

#include <algorithm>
#include <numeric>

#include "generators.hpp"

namespace tencer::property {

template <class Place>
void move_ends(model::Structure& structure, int rod, Place&& place) {
  for (springs::Cable& cable : structure.cables)
    for (springs::End* end : {&cable.a, &cable.b})
      if (auto* on_rod = std::get_if<springs::OnRod>(end); on_rod && on_rod->rod == rod)
        on_rod->s = place(on_rod->s);
}

struct Motion {
  Eigen::Matrix3d turn;
  Eigen::Vector3d shift;
};

inline Motion motion() { return {rotation(), vectors(1, 5)}; }

inline Posed moved(Posed a, const Motion& by) {
  a.structure.anchors = (by.turn * a.structure.anchors).colwise() + by.shift;
  for (auto& x : a.x) x = ((by.turn * x).colwise() + by.shift).eval();
  return a;
}

inline model::State moved(model::State state, const Motion& by) {
  for (der::RodState& rod : state) {
    rod.x = ((by.turn * rod.x).colwise() + by.shift).eval();
    rod.frames.tangent = by.turn * rod.frames.tangent;
    rod.frames.director = by.turn * rod.frames.director;
  }
  return state;
}

// Closed rods start at another vertex.
inline Posed started_elsewhere(const Posed& a) {
  Posed b = a;
  for (int r = 0; r < static_cast<int>(a.x.size()); ++r) {
    der::Rod& rod = b.structure.rods[r];
    if (!rod.closed) continue;
    const int by = whole(0, rod.edges() - 1);
    const double start = geometry::ArcLength(rod.rest_lengths, true).knots()[by];
    std::rotate(rod.rest_lengths.begin(), rod.rest_lengths.begin() + by, rod.rest_lengths.end());
    if (rod.rest_twist.size() > 0)
      std::rotate(rod.rest_twist.begin(), rod.rest_twist.begin() + by, rod.rest_twist.end());
    for (Eigen::Index i = 0; i < a.x[r].cols(); ++i)
      b.x[r].col(i) = a.x[r].col((i + by) % a.x[r].cols());
    move_ends(b.structure, r, [&](double s) { return s - start; });
  }
  return b;
}

// The rod, straight at rest, seen from its other end; vertex 0 of a closed one stays where it is.
inline der::Rod reversed(der::Rod rod) {
  rod.rest_lengths.reverseInPlace();
  if (rod.rest_twist.size() > 0) {
    rod.rest_twist.reverseInPlace();
    // The seam's comes first and stays there.
    if (rod.closed)
      std::rotate(rod.rest_twist.begin(), rod.rest_twist.end() - 1, rod.rest_twist.end());
  }
  return rod;
}

inline Eigen::Matrix3Xd reversed(const Eigen::Matrix3Xd& x, bool closed) {
  const Eigen::Index n = x.cols();
  Eigen::Matrix3Xd result(3, n);
  for (Eigen::Index i = 0; i < n; ++i) result.col(i) = x.col(closed ? (n - i) % n : n - 1 - i);
  return result;
}

inline Posed reversed(const Posed& a) {
  Posed b = a;
  for (int r = 0; r < static_cast<int>(a.x.size()); ++r) {
    const der::Rod& rod = a.structure.rods[r];
    b.structure.rods[r] = reversed(rod);
    b.x[r] = reversed(a.x[r], rod.closed);
    const double length = rod.length();
    const bool closed = rod.closed;
    move_ends(b.structure, r,
              [&](double s) { return length - (closed ? s : std::clamp(s, 0.0, length)); });
  }
  return b;
}

// order[i]: which rod becomes rod i.
inline std::vector<int> order_of_rods(const Posed& a) {
  std::vector<int> order(a.x.size());
  std::iota(order.begin(), order.end(), 0);
  std::rotate(order.begin(), order.begin() + whole(0, static_cast<int>(order.size()) - 1),
              order.end());
  if (coin()) std::ranges::reverse(order);
  return order;
}

// Cables too are listed the other way round, and some of them from their other ends.
inline Posed listed(const Posed& a, const std::vector<int>& order) {
  Posed b = a;
  std::vector<int> number_of(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    b.structure.rods[i] = a.structure.rods[order[i]];
    b.x[i] = a.x[order[i]];
    number_of[order[i]] = static_cast<int>(i);
  }
  for (springs::Cable& cable : b.structure.cables) {
    for (springs::End* end : {&cable.a, &cable.b})
      if (auto* on_rod = std::get_if<springs::OnRod>(end)) on_rod->rod = number_of[on_rod->rod];
    if (coin()) std::swap(cable.a, cable.b);
  }
  std::ranges::reverse(b.structure.cables);
  return b;
}

struct Units {
  double length = 1.0;
  double modulus = 1.0;
  double force() const { return modulus * length * length; }
};

inline Posed in_units(Posed a, const Units& units) {
  const double force = units.force(), length = units.length;
  for (der::Rod& rod : a.structure.rods) {
    rod.section.EA *= force;
    rod.section.EI1 *= force * length * length;
    rod.section.EI2 *= force * length * length;
    rod.section.GJ *= force * length * length;
    rod.rest_lengths *= length;
  }
  for (auto& x : a.x) x *= length;
  a.structure.anchors *= length;
  for (springs::Cable& cable : a.structure.cables) {
    cable.stiffness *= force / length;
    cable.rest_length *= length;
  }
  for (int r = 0; r < static_cast<int>(a.x.size()); ++r)
    move_ends(a.structure, r, [&](double s) { return s * length; });
  return a;
}

}  // namespace tencer::property
