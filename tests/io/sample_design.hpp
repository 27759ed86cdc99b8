// A design with something of everything.
#pragma once

#include <limits>
#include <random>
#include <tencer/model/design.hpp>

inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

// A closed rod of 4 vertices, an open one of 3, two anchors, one cable of each kind; numbers whose
// digits need the full precision.
inline tencer::model::Design sample() {
  using namespace tencer;
  using namespace tencer::model;
  Design design;
  design.name = "two \"rods\"";
  design.status = DesignStatus::tolerance_not_reached;
  design.length_unit = "mm";
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> uniform(0.1, 1.0);
  const auto number = [&] { return uniform(random); };
  Structure& structure = design.structure;
  for (const bool closed : {true, false}) {
    const int n = closed ? 4 : 3;
    const int edges = closed ? n : n - 1;
    structure.rods.push_back({.closed = closed,
                              .section = {.EA = 1e7 * number(),
                                          .EI1 = number(),
                                          .EI2 = number(),
                                          .GJ = 1e-300 * number()},
                              .rest_lengths = Eigen::VectorXd::NullaryExpr(edges, number)});
    design.target.emplace_back(Eigen::Matrix3Xd::NullaryExpr(3, n, number));
    design.pose.emplace_back(Eigen::Matrix3Xd::NullaryExpr(3, n, number));
  }
  design.pose[0](0, 0) = -0.0;
  der::Rod& closed = structure.rods[0];
  closed.closing_angle = number();
  closed.rest_curvature = Eigen::Matrix2Xd::NullaryExpr(2, 4, number);
  closed.rest_twist = Eigen::VectorXd::NullaryExpr(4, number);
  design.target_directors = {Eigen::Matrix3Xd::NullaryExpr(3, 4, number), Eigen::Matrix3Xd(3, 0)};
  design.pose_directors = {Eigen::Matrix3Xd(3, 0), Eigen::Matrix3Xd::NullaryExpr(3, 2, number)};
  structure.point_loads = {{1, 0.0, {number(), -number(), number()}}};
  structure.line_loads = {{0, {0, 0, -number()}}, {1, {0, 0, -number()}}};
  structure.anchors = Eigen::Matrix3Xd::NullaryExpr(3, 2, number);
  structure.pins = {{0, 3, {true, false, true}}, {1, 0, {true, true, true}}};
  structure.cables.push_back(
      {.a = springs::OnRod{0, closed.length()}, .b = springs::OnRod{1, 0.0}});
  design.built.push_back({.length = number(), .tension = number()});
  structure.cables.push_back({.a = springs::OnRod{1, number() / 10},
                              .b = springs::AtAnchor{1},
                              .stiffness = number(),
                              .rest_length = 0.0});
  design.built.push_back({.length = number(), .tension = -number()});
  structure.planar = true;
  design.error = DesignError{number(), number()};
  design.at_least =
      AtLeast{.cables = 1, .ends = 2, .error_percent = 0.5, .stretches = {{1, 0.0, 0.75}}};
  design.certificate = Certificate{.residual = 1e-12 * number(),
                                   .smallest_eigenvalue = -number(),
                                   .slack_cables = 1,
                                   .stable = false,
                                   .off_by_errors = 0.25,
                                   .settles_from_target = false};
  design.trace = {{"prune", number(), 87, no_number, no_number, 3, 40, "a, b"},
                  {"greedy", number(), 51, number(), number(), 5, 60, ""}};
  design.trace[1].snapshots = {{.max_percent = number(),
                                .rods = {Eigen::Matrix3Xd::Random(3, 4)},
                                .cable_ends = Eigen::Matrix3Xd::Random(3, 4),
                                .tensions = Eigen::Vector2d(-number(), number())}};
  return design;
}
