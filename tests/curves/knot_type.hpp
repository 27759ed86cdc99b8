// What a closed polyline is knotted like, from its shadows.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <tencer/geometry/polyline.hpp>
#include <utility>
#include <vector>

namespace tencer {

// A double point of the shadow. Places along the curve: edge + t.
struct Crossing {
  double over = 0.0;
  double under = 0.0;
  bool positive = false;
};

// Seen from this direction, in the order of the places below. The direction must be generic.
inline std::vector<Crossing> crossings(const geometry::Polyline& curve,
                                       const Eigen::Vector3d& direction) {
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond::FromTwoVectors(direction, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Matrix3Xd x = turn * curve.points;
  const int n = curve.vertices();
  std::vector<Crossing> found;
  for (int i = 0; i < n; ++i)
    for (int j = i + 2; j < n - (i == 0 ? 1 : 0); ++j) {
      const Eigen::Vector3d a = x.col(i), along_a = x.col((i + 1) % n) - a;
      const Eigen::Vector3d b = x.col(j), along_b = x.col((j + 1) % n) - b;
      const double cross = along_a.x() * along_b.y() - along_a.y() * along_b.x();
      const Eigen::Vector3d apart = b - a;
      const double s = (apart.x() * along_b.y() - apart.y() * along_b.x()) / cross;
      const double t = (apart.x() * along_a.y() - apart.y() * along_a.x()) / cross;
      if (!(s >= 0 && s < 1 && t >= 0 && t < 1)) continue;
      const bool a_over = (a + s * along_a).z() > (b + t * along_b).z();
      found.push_back({.over = a_over ? i + s : j + t,
                       .under = a_over ? j + t : i + s,
                       .positive = (cross > 0) == a_over});
    }
  std::ranges::sort(found, {}, &Crossing::under);
  return found;
}

// |Delta(e^{i angle})| of the Alexander polynomial, by Fox's calculus on the shadow. The usual
// ambiguity, a factor +-t^k, leaves the absolute value as it is.
inline double alexander(const std::vector<Crossing>& shadow, double angle) {
  const int n = static_cast<int>(shadow.size());
  if (n == 0) return 1.0;
  const std::complex<double> t = std::polar(1.0, angle);
  // Arc k runs from the k-th undercrossing to the next; arc n-1 goes through the start.
  const auto arc_at = [&](double place) {
    const auto after = std::ranges::upper_bound(shadow, place, {}, &Crossing::under);
    return (static_cast<int>(after - shadow.begin()) + n - 1) % n;
  };
  Eigen::MatrixXcd relations = Eigen::MatrixXcd::Zero(n, n);
  for (int k = 0; k < n; ++k) {
    const int in = (k + n - 1) % n;
    relations(k, arc_at(shadow[k].over)) += 1.0 - t;
    relations(k, shadow[k].positive ? in : k) += t;
    relations(k, shadow[k].positive ? k : in) -= 1.0;
  }
  return n == 1 ? 1.0 : std::abs(relations.topLeftCorner(n - 1, n - 1).determinant());
}

// |V(e^{i angle})| of the Jones polynomial, as the Kauffman bracket at A = e^{-i angle / 4}: a sum
// over the 2^crossings ways to cut the crossings open. The same for a knot and its mirror image.
inline double jones(const std::vector<Crossing>& shadow, double angle) {
  const int n = static_cast<int>(shadow.size());
  std::vector<std::pair<double, int>> passages;  // place, crossing
  for (int k = 0; k < n; ++k) {
    passages.emplace_back(shadow[k].over, k);
    passages.emplace_back(shadow[k].under, k);
  }
  std::ranges::sort(passages);
  // Piece p of the curve runs from passage p to the next.
  std::vector<std::array<int, 4>> pieces(n);  // over in, over out, under in, under out
  for (int p = 0; p < 2 * n; ++p) {
    const auto& [place, k] = passages[p];
    const int way = place == shadow[k].over ? 0 : 2;
    pieces[k][way] = (p + 2 * n - 1) % (2 * n);
    pieces[k][way + 1] = p;
  }
  const std::complex<double> a = std::polar(1.0, -angle / 4);
  const std::complex<double> loop = -a * a - 1.0 / (a * a);
  std::complex<double> sum = 0;
  for (int state = 0; state < 1 << n; ++state) {
    std::vector<int> parent(2 * n);
    std::iota(parent.begin(), parent.end(), 0);
    int loops = 2 * n;
    const auto root = [&](int piece) {
      while (parent[piece] != piece) piece = parent[piece];
      return piece;
    };
    const auto join = [&](int one, int other) {
      if (root(one) == root(other)) return;
      parent[root(one)] = root(other);
      --loops;
    };
    int power = 0;
    for (int k = 0; k < n; ++k) {
      const bool cut_a = (state >> k) & 1;
      power += cut_a ? 1 : -1;
      const auto& [over_in, over_out, under_in, under_out] = pieces[k];
      // The A-cut of a positive crossing keeps to the curve's direction.
      if (cut_a == shadow[k].positive) {
        join(over_in, under_out);
        join(under_in, over_out);
      } else {
        join(over_in, under_in);
        join(over_out, under_out);
      }
    }
    sum += std::pow(a, power) * std::pow(loop, loops - 1);
  }
  return n == 0 ? 1.0 : std::abs(sum);
}

// Evenly spread directions that are generic in all likelihood.
inline Eigen::Vector3d direction(int i, int count) {
  const double z = 1 - (2 * i + 1.0) / count;
  const double angle = std::numbers::pi * (1 + std::sqrt(5.0)) * i + 0.123;
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

}  // namespace tencer
