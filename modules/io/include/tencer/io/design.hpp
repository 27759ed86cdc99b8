// The design file, design.json, schema "tencer-design/1": a designed structure and what is known of
// it. Plain data in the file's own units.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/io/load.hpp>
#include <tencer/io/pin.hpp>
#include <tencer/io/trace.hpp>
#include <vector>

namespace tencer::io {

// n vertices; e edges and rest_lengths, n when closed, n - 1 when open; target and pose: 3 x n. In
// the file a matrix of points is an array of n triples.
struct DesignRod {
  bool closed = false;
  double EA = 0.0;
  Eigen::Vector2d EI = Eigen::Vector2d::Zero();
  double GJ = 0.0;
  Eigen::VectorXd rest_lengths;
  Eigen::Matrix3Xd target;
  Eigen::Matrix3Xd pose;
  // Of a closed rod: the angle by which its end is turned against its start before the two are
  // glued, radians; absent: however it likes.
  std::optional<double> closing_angle = std::nullopt;
  // Bends and twists at rest, as in der::Rod: 2 x b and b, b the vertices that are no ends. Empty,
  // and not in the file: straight, untwisted.
  Eigen::Matrix2Xd rest_curvature = Eigen::Matrix2Xd(2, 0);
  Eigen::VectorXd rest_twist = Eigen::VectorXd(0);
  // 3 x e: where the section's first axis points on every edge, as far as it is perpendicular to
  // the edge. Empty, and not in the file: not known, or of no consequence.
  Eigen::Matrix3Xd target_directors = Eigen::Matrix3Xd(3, 0);
  Eigen::Matrix3Xd pose_directors = Eigen::Matrix3Xd(3, 0);

  double length() const { return rest_lengths.sum(); }
};

// Where a cable ends: on a rod at arc length s at rest, in [0, length of the rod], or at an anchor.
// Exactly one of rod and anchor is >= 0.
struct CableEnd {
  int rod = -1;
  double s = 0.0;
  int anchor = -1;
};

// length and tension: of the inextensible cable at the pose. A cable that is to be simulated as a
// spring also has a stiffness (force per length) and a rest length; both or neither.
struct DesignCable {
  CableEnd a;
  CableEnd b;
  double length = 0.0;
  double tension = 0.0;
  std::optional<double> stiffness = std::nullopt;
  std::optional<double> rest_length = std::nullopt;
};

// Distance of the pose to the target in percent of the target's bounding-box diagonal.
struct DesignError {
  double max_percent = 0.0;
  double rms_percent = 0.0;
};

// Of the built form, with inextensible cables of the given lengths that cannot push. residual is
// relative to the rods' internal force; smallest_eigenvalue is that of the Hessian of the
// Lagrangian on the null space of taut cables and rigid motions, in eigenvalue_unit.
struct Certificate {
  double residual = 0.0;
  double smallest_eigenvalue = 0.0;
  std::string eigenvalue_unit;
  int slack_cables = 0;
  bool stable = false;
  // Whether the built form, let go at the target, comes to rest in the pose; absent: not tried.
  std::optional<bool> settles_from_target = std::nullopt;
};

enum class DesignStatus { complete, tolerance_not_reached, interrupted };

struct Design {
  std::string name;
  DesignStatus status = DesignStatus::complete;
  std::string length_unit = "cm";
  std::string force_unit = "N";
  std::vector<DesignRod> rods;
  Eigen::Matrix3Xd anchors = Eigen::Matrix3Xd(3, 0);
  std::vector<Pin> pinned;
  std::vector<PointLoad> point_loads;
  std::vector<LineLoad> line_loads;
  bool planar = false;  // all z coordinates are held
  std::vector<DesignCable> cables;
  std::optional<DesignError> error = std::nullopt;  // absent in a design that nobody solved yet
  std::optional<Certificate> certificate = std::nullopt;  // likewise
  std::vector<TraceRow> trace;
};

// Keys that are not there mean none (anchors, pins, loads, ...). Keys that are not of the schema
// are left alone: other programs may add theirs. Everything else is checked: sizes, indices, finite
// numbers, s in [0, length], positive stiffnesses and lengths. Errors: "file: key", such as
// "design.json: rods[1].rest_lengths".
core::Expected<Design> read_design(const std::filesystem::path& path);

// The text of the file, unchecked. All doubles round-trip.
std::string design_text(const Design& design);

// What read_design would refuse in the design's text; errors name `path`, which is not touched.
std::optional<core::Error> design_problem(const std::filesystem::path& path, const Design& design);

// Makes these checks first, so that no file is written that read_design refuses.
std::optional<core::Error> write_design(const std::filesystem::path& path, const Design& design);

// "complete", "tolerance-not-reached", "interrupted".
const char* status_name(DesignStatus status);

}  // namespace tencer::io
