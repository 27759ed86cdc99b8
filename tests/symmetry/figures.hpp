// Figures and random cables for the tests of symmetry.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <tencer/curves/analytic.hpp>
#include <tencer/geometry/sampling.hpp>
#include <tencer/springs/cable.hpp>
#include <tencer/symmetry/detect.hpp>
#include <vector>

namespace tencer::symmetry {

using model::Reflection;
using model::Rotation;

inline Figure figure_of(std::vector<geometry::Polyline> curves) {
  Figure figure{.curves = std::move(curves)};
  for (const geometry::Polyline& curve : figure.curves)
    figure.rods.push_back(geometry::arc_length(curve));
  return figure;
}

inline Figure trefoil(int vertices) {
  return figure_of({curves::trefoil(curves::TrefoilForm::hypotrochoid, 30.0, vertices)});
}

// A smooth closed curve without any symmetry.
inline geometry::Polyline random_curve(std::mt19937& random, int vertices) {
  std::normal_distribution<double> normal;
  Eigen::Matrix<double, 3, 8> c =
      Eigen::Matrix<double, 3, 8>::NullaryExpr([&] { return normal(random); });
  return geometry::sample(
      [c](double t) {
        Eigen::Vector3d x = Eigen::Vector3d::Zero();
        for (int k = 0; k < 4; ++k)
          x += (c.col(2 * k) * std::cos((k + 1) * t) + c.col(2 * k + 1) * std::sin((k + 1) * t)) /
               (k + 1.0);
        return x;
      },
      0.0, 2.0 * std::numbers::pi, vertices, true);
}

inline springs::End random_end(std::mt19937& random, const Figure& figure, int rod) {
  return springs::OnRod{rod,
                        std::uniform_real_distribution<>(0.0, figure.rods[rod].length())(random)};
}

// From the first rod to the last.
inline springs::Cable random_cable(std::mt19937& random, const Figure& figure) {
  return {.a = random_end(random, figure, 0),
          .b = random_end(random, figure, static_cast<int>(figure.rods.size()) - 1),
          .stiffness = std::uniform_real_distribution<>(0.5, 2.0)(random),
          .rest_length = 0.1};
}

inline Eigen::Vector3d point(const Figure& figure, const springs::End& end) {
  if (const auto* at_anchor = std::get_if<springs::AtAnchor>(&end))
    return figure.anchors.col(at_anchor->anchor);
  const auto& on_rod = std::get<springs::OnRod>(end);
  return geometry::point_at(figure.curves[on_rod.rod], figure.rods[on_rod.rod], on_rod.s);
}

inline double span(const Figure& figure, const springs::Cable& cable) {
  return (point(figure, cable.a) - point(figure, cable.b)).norm();
}

// How many axes of the fold, and mirror planes.
inline int axes(const Symmetry& symmetry, int fold) {
  int count = 0;
  for (const model::SymmetryGenerator& element : symmetry.elements)
    if (const auto* rotation = std::get_if<Rotation>(&element))
      count += rotation->fold == fold ? 1 : 0;
  return count;
}
inline int planes(const Symmetry& symmetry) {
  int count = 0;
  for (const model::SymmetryGenerator& element : symmetry.elements)
    count += std::holds_alternative<Reflection>(element) ? 1 : 0;
  return count;
}

}  // namespace tencer::symmetry
