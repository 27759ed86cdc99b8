#include <catch2/catch.hpp>
#include <tencer/springs/derivatives.hpp>
#include <tencer/springs/law.hpp>
#include <vector>

namespace tencer::springs {
namespace {

const Eigen::Vector3d span(0.8, -1.1, 0.4);  // of length 1.418

Cable spring(double rest_length, bool tension_only = false) {
  return {.a = OnRod{0, 0.0},
          .b = OnRod{0, 1.0},
          .stiffness = 2.3,
          .rest_length = rest_length,
          .tension_only = tension_only};
}

std::vector<Cable> springs_of_all_sorts() {
  return {spring(0.9), spring(2.2), spring(0.9, true), spring(2.2, true), spring(1e-3)};
}

Cable moved(Cable cable, double stiffness, double rest_length) {
  cable.stiffness += stiffness;
  cable.rest_length += rest_length;
  return cable;
}

}  // namespace

TEST_CASE("forces vary with stiffness and rest length as differences say") {
  constexpr double h = 1e-5;
  for (const Cable& cable : springs_of_all_sorts()) {
    const Eigen::Vector3d by_stiffness =
        (force(moved(cable, h, 0), span) - force(moved(cable, -h, 0), span)) / (2 * h);
    const Eigen::Vector3d by_rest_length =
        (force(moved(cable, 0, h), span) - force(moved(cable, 0, -h), span)) / (2 * h);
    CHECK((force_by_stiffness(cable, span) - by_stiffness).norm() < 1e-9);
    CHECK((force_by_rest_length(cable, span) - by_rest_length).norm() < 1e-9);
  }
  CHECK((force_by_stiffness(spring(0), span) - span).norm() < 1e-15);
}

TEST_CASE("weights vary along the edges they are on") {
  const std::vector<geometry::ArcLength> rods{{Eigen::Vector4d(0.1, 0.7, 0.3, 0.2), true},
                                              {Eigen::Vector3d(0.5, 0.25, 0.3), false}};
  const Eigen::Matrix3Xd anchors = Eigen::Vector3d(1, -2, 3);
  const auto weights = [&](const Cable& cable) {
    const Stencil made = stencil(cable, rods, anchors);
    Eigen::Vector4d result = Eigen::Vector4d::Zero();
    for (int i = 0; i < made.count; ++i) result[i] = made.shares[i].weight;
    return result;
  };
  const auto slid = [](End end, double h) {
    if (auto* on_rod = std::get_if<OnRod>(&end)) on_rod->s += h;
    return end;
  };
  constexpr double h = 1e-4;
  // In the middle of edges, one of them across the seam; on one rod and on two; anchored.
  const End ends[] = {OnRod{0, 0.3}, OnRod{0, -0.07}, OnRod{1, 0.6}, AtAnchor{0}};
  for (const End& a : ends)
    for (const End& b : ends) {
      if (std::holds_alternative<AtAnchor>(a) && std::holds_alternative<AtAnchor>(b)) continue;
      const Cable cable{.a = a, .b = b};
      const Stencil made = stencil(cable, rods, anchors);
      const auto rates_a = weight_rates(cable, made, rods, Attachment::a);
      const auto rates_b = weight_rates(cable, made, rods, Attachment::b);
      const Eigen::Vector4d by_a =
          (weights({.a = slid(a, h), .b = b}) - weights({.a = slid(a, -h), .b = b})) / (2 * h);
      const Eigen::Vector4d by_b =
          (weights({.a = a, .b = slid(b, h)}) - weights({.a = a, .b = slid(b, -h)})) / (2 * h);
      CHECK((Eigen::Vector4d::Map(rates_a.data()) - by_a).norm() < 1e-10);
      CHECK((Eigen::Vector4d::Map(rates_b.data()) - by_b).norm() < 1e-10);
    }
}

TEST_CASE("at a vertex weights vary as on the edge of the stencil") {
  const std::vector<geometry::ArcLength> rods{{Eigen::Vector4d(0.1, 0.7, 0.3, 0.2), true}};
  const Cable cable{.a = OnRod{0, 0.0}, .b = OnRod{0, 0.5}};
  const auto rates = [&](geometry::Side side) {
    const Stencil made = stencil(cable, rods, Eigen::Matrix3Xd(3, 0), side);
    return weight_rates(cable, made, rods, Attachment::a);
  };
  CHECK(rates(geometry::Side::after)[0] == Approx(1 / 0.1));
  CHECK(rates(geometry::Side::before)[0] == Approx(1 / 0.2));
}

TEST_CASE("mixed second variations agree with differences") {
  const Variation variation{.span_1 = {0.3, 0.5, -0.2},
                            .span_2 = {-0.6, 0.1, 0.4},
                            .span_12 = {0.2, -0.3, 0.7},
                            .stiffness_2 = 0.8,
                            .rest_length_2 = -0.5};
  constexpr double h = 1e-4;
  for (const Cable& cable : springs_of_all_sorts()) {
    // Force, dE/dk and dE/dl at parts x and y of the two directions.
    const auto at = [&](double x, double y) {
      const Cable other = moved(cable, y * variation.stiffness_2, y * variation.rest_length_2);
      const Eigen::Vector3d d =
          span + x * variation.span_1 + y * variation.span_2 + x * y * variation.span_12;
      const double pull = tension(other, d.norm());
      Eigen::Matrix<double, 5, 1> result;
      const double stretch = pull / other.stiffness;
      result << force(other, d), stretch * stretch / 2, -pull;
      return result;
    };
    const Response response = respond(cable, span, variation);
    const Eigen::Vector3d first = ((at(h, 0) - at(-h, 0)) / (2 * h)).head<3>();
    const Eigen::Vector3d second = ((at(0, h) - at(0, -h)) / (2 * h)).head<3>();
    CHECK((response.force_1 - first).norm() < 1e-7);
    CHECK((response.force_2 - second).norm() < 1e-7);
    Eigen::Matrix<double, 5, 1> mixed;
    mixed << response.force_12, response.by_stiffness_12, response.by_rest_length_12;
    CHECK((mixed - (at(h, h) - at(h, -h) - at(-h, h) + at(-h, -h)) / (4 * h * h)).norm() < 1e-6);
  }
}

TEST_CASE("without length and rest length a spring's force varies as k d does") {
  const Variation variation{.span_1 = {0.3, 0.5, -0.2},
                            .span_2 = {-0.6, 0.1, 0.4},
                            .span_12 = {0.2, -0.3, 0.7},
                            .stiffness_2 = 0.8};
  for (const bool tension_only : {false, true}) {
    const Cable cable = spring(0, tension_only);
    const Response response = respond(cable, Eigen::Vector3d::Zero(), variation);
    CHECK(response.force_1 == cable.stiffness * variation.span_1);
    CHECK(response.force_2 == cable.stiffness * variation.span_2);
    CHECK(response.force_12 == cable.stiffness * variation.span_12 + 0.8 * variation.span_1);
    CHECK(response.by_stiffness_12 == variation.span_1.dot(variation.span_2));
  }
}

}  // namespace tencer::springs
