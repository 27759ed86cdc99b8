// Small structures in generic poses whose equilibria depend on every parameter.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <tencer/sensitivity/derivatives.hpp>
#include <vector>

namespace tencer::sensitivity {

using springs::ParameterKind;

struct Example {
  std::string name{};
  model::Structure structure{};
  std::vector<Eigen::Matrix3Xd> start{};
  model::Target target{};
};

inline Eigen::Matrix3Xd ring(int n, double radius, double wave, const Eigen::Vector3d& centre) {
  Eigen::Matrix3Xd x(3, n);
  for (int i = 0; i < n; ++i) {
    const double phi = 2 * std::numbers::pi * i / n;
    x.col(i) = centre + radius * Eigen::Vector3d(std::cos(phi), std::sin(phi),
                                                 wave * std::sin(2 * phi + 0.3));
  }
  return x;
}

inline Eigen::Matrix3Xd arc(int n, double radius, double angle, double pitch) {
  Eigen::Matrix3Xd x(3, n);
  for (int i = 0; i < n; ++i) {
    const double phi = angle * i / (n - 1);
    x.col(i) = Eigen::Vector3d(radius * std::cos(phi), radius * std::sin(phi), pitch * phi);
  }
  return x;
}

inline der::Rod rod_along(const Eigen::Matrix3Xd& x, bool closed, const der::Section& section) {
  const int edges = static_cast<int>(x.cols()) - (closed ? 0 : 1);
  der::Rod rod{.closed = closed, .section = section, .rest_lengths = Eigen::VectorXd(edges)};
  for (int j = 0; j < edges; ++j)
    rod.rest_lengths[j] = (x.col((j + 1) % static_cast<int>(x.cols())) - x.col(j)).norm();
  return rod;
}

inline springs::Cable cable(int rod_a, double s_a, int rod_b, double s_b, double stiffness,
                            double rest_length) {
  return {.a = springs::OnRod{rod_a, s_a},
          .b = springs::OnRod{rod_b, s_b},
          .stiffness = stiffness,
          .rest_length = rest_length};
}

inline springs::Cable anchored(int anchor, int rod, double s, double stiffness,
                               double rest_length) {
  return {.a = springs::AtAnchor{anchor},
          .b = springs::OnRod{rod, s},
          .stiffness = stiffness,
          .rest_length = rest_length};
}

// A shape a little off every rod's start.
inline std::vector<Eigen::Matrix3Xd> nearby(const std::vector<Eigen::Matrix3Xd>& start) {
  std::vector<Eigen::Matrix3Xd> points = start;
  for (auto& x : points)
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
      const double phase = static_cast<double>(i);
      x.col(i) += 0.05 * Eigen::Vector3d(std::sin(0.9 * phase), std::cos(0.7 * phase),
                                         std::sin(0.5 * phase + 1));
    }
  return points;
}

inline der::Section round_section(double EA) { return {.EA = EA, .EI1 = 1, .EI2 = 1, .GJ = 0.8}; }

// `EA`: EI is 1 and lengths are around 6, so EA = 1e3 is moderate and 1e7 a thin wire.
inline Example closed_rod(double EA) {
  Example e{.name = "closed rod"};
  e.start = {ring(24, 1, 0.25, {0.1, -0.2, 0.3})};
  e.structure.rods = {rod_along(e.start[0], true, round_section(EA))};
  e.structure.cables = {cable(0, 0.33, 0, 3.4, 4.0, 0.5), cable(0, 1.21, 0, 4.57, 3.0, 0.9),
                        cable(0, 2.05, 0, -0.85, 2.0, 0.0), cable(0, 5.05, 0, 3.13, 5.0, 0.3)};
  e.target = model::make_target(e.structure, nearby(e.start));
  return e;
}

inline Example open_rod() {
  Example e{.name = "open rod"};
  e.start = {arc(20, 1.1, 4.2, 0.2)};
  e.structure.rods = {rod_along(e.start[0], false, round_section(500))};
  e.structure.cables = {cable(0, 0.02, 0, 4.57, 4.0, 0.8), cable(0, 0.71, 0, 3.03, 2.0, 0.6),
                        cable(0, 2.05, 0, 4.05, 2.0, 0.2)};
  e.target = model::make_target(e.structure, nearby(e.start));
  e.target.weights = {Eigen::VectorXd::LinSpaced(20, 0, 2)};
  return e;
}

inline Example anchored_rod() {
  Example e = open_rod();
  e.name = "anchored rod";
  e.structure.anchors.resize(3, 4);
  e.structure.anchors << 2, -2, 0, 0, 0, 1, 2, -2, 1, 0, -1, 1;
  e.structure.cables.push_back(anchored(0, 0, 0.31, 3.0, 0.4));
  e.structure.cables.push_back(anchored(1, 0, 2.6, 2.0, 0.3));
  e.structure.cables.push_back(anchored(2, 0, 1.5, 2.5, 0.0));
  e.structure.cables.push_back(anchored(3, 0, 4.0, 2.5, 0.7));
  e.target = model::make_target(e.structure, nearby(e.start));
  return e;
}

inline Example two_rods() {
  Example e{.name = "two rods"};
  e.start = {ring(20, 1, 0.2, {0, 0, 0}), ring(16, 0.8, -0.3, {0.2, 0.1, 0.9})};
  e.structure.rods = {rod_along(e.start[0], true, round_section(400)),
                      rod_along(e.start[1], true, round_section(900))};
  for (int c = 0; c < 5; ++c)
    e.structure.cables.push_back(cable(0, 1.21 * c + 0.1, 1, 0.97 * c + 0.4, 2.0 + c, 0.3));
  e.structure.cables.push_back(cable(0, 0.45, 0, 3.52, 1.5, 0.5));
  e.structure.cables.push_back(cable(1, 0.13, 1, 2.52, 1.5, 0.5));
  e.target = model::make_target(e.structure, nearby(e.start));
  return e;
}

inline Example planar_rod() {
  Example e{.name = "planar rod"};
  e.start = {ring(22, 1, 0, {0.3, 0.1, 0})};
  e.structure.rods = {rod_along(e.start[0], true, round_section(700))};
  e.structure.planar = true;
  e.structure.cables = {cable(0, 0.33, 0, 3.4, 3.0, 0.5), cable(0, 1.21, 0, 4.57, 2.0, 0.9),
                        cable(0, 2.05, 0, 5.35, 1.0, 0.0)};
  e.target = model::make_target(e.structure, nearby(e.start));
  return e;
}

inline Example uniformly_twisted() {
  Example e = closed_rod(600);
  e.name = "closed rod with a closing angle";
  e.structure.rods[0].closing_angle = 0.6;
  return e;
}

inline Example strip() {
  Example e = anchored_rod();
  e.name = "strip with material frames";
  e.structure.rods[0].section.EI2 = 0.3;
  return e;
}

inline Example seen(Example e, std::vector<model::View> views) {
  e.name += ", " + model::seen_in_words(views);
  e.target.views = std::move(views);
  return e;
}

inline std::vector<Example> examples() {
  const std::vector<model::View> oblique{{.direction = {0.4, -0.2, 1}}};
  const std::vector<model::View> two{{.direction = {1, 0.1, 0}, .weight = 3},
                                     {.direction = {0, 0.5, 2}}};
  return {closed_rod(1e3),
          open_rod(),
          anchored_rod(),
          two_rods(),
          planar_rod(),
          uniformly_twisted(),
          strip(),
          seen(two_rods(), oblique),
          seen(closed_rod(1e3), two),
          seen(open_rod(), oblique),
          seen(anchored_rod(), oblique),
          seen(strip(), two)};
}

inline Tracker track(const Example& e, const TrackerOptions& options = {.tolerance = 1e-13}) {
  return Tracker(e.structure, model::make_state(e.structure, e.start), options);
}

// All parameters that may vary both ways.
inline std::vector<springs::Parameter> all_parameters(const model::Structure& structure) {
  std::vector<springs::Parameter> parameters;
  for (int c = 0; c < static_cast<int>(structure.cables.size()); ++c) {
    parameters.push_back({ParameterKind::stiffness, c});
    if (structure.cables[c].rest_length > 0) parameters.push_back({ParameterKind::rest_length, c});
    if (std::holds_alternative<springs::OnRod>(structure.cables[c].a))
      parameters.push_back({ParameterKind::position_a, c});
    if (std::holds_alternative<springs::OnRod>(structure.cables[c].b))
      parameters.push_back({ParameterKind::position_b, c});
  }
  return parameters;
}

inline Distance distance(const model::Target& target, const Configuration& at) {
  return Distance(target, at.system, at.state);
}

}  // namespace tencer::sensitivity
