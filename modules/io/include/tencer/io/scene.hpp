// The scene: targets, rods, supports and how to design, as a TOML file says them. docs/scene.md
// describes the file.
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/geometry/polyline.hpp>
#include <tencer/io/load.hpp>
#include <tencer/io/pin.hpp>
#include <tencer/io/symmetry.hpp>
#include <vector>

namespace tencer::io {

// A rod's stiffnesses: EA a force, EI (about the first and second axis of the section) and GJ force
// times length^2.
struct Section {
  double EA = 0.0;
  Eigen::Vector2d EI = Eigen::Vector2d::Zero();
  double GJ = 0.0;
};

// Young's modulus of glass fibre, 40 GPa (paper table 1), in force_unit / length_unit^2. Units: mm,
// cm, m; mN, N, kN.
double glass_fibre_modulus(const std::string& length_unit, const std::string& force_unit);

// A part of a rod by arc length of its target, in [0, length]. On a closed rod from > to means
// through the seam.
struct Arc {
  double from = 0.0;
  double to = 0.0;
};

// How a rod is bent at rest: straight; or with the same curvature (1 / length) all along, towards
// the section's first axis; or along a curve, open or closed and as long as the target, with the
// section's first axis at its start turned to `director`, as far as that is perpendicular to it.
struct RestShape {
  double curvature = 0.0;
  std::optional<geometry::Polyline> curve = std::nullopt;
  std::optional<Eigen::Vector3d> director = std::nullopt;
};

struct SceneRod {
  geometry::Polyline target;
  Section section;
  RestShape rest;
  // Where the section's first axis points at the start of the target, to begin with; not set:
  // however the rod likes best.
  std::optional<Eigen::Vector3d> director;
  std::optional<double> closing_angle;  // of a closed rod, radians; not set: free
  Eigen::VectorXd weights;              // of each vertex in the distance to the target; >= 0
  std::vector<Arc> forbidden_arcs;      // no cable attaches here
  std::vector<int> forbidden_vertices;  // nor here
  std::string source;                   // where it came from: "scene.toml:12" or "curve.obj"
};

struct DesignSettings {
  std::string method = "force-balance";      // force-balance, dense-springs
  std::string optimizer = "gauss-newton";    // gauss-newton, ipopt, mma, ccsaq
  std::string hessian = "gauss-newton";      // limited-memory, gauss-newton, exact
  double max_error = 1.0;                    // percent of the bounding-box diagonal
  std::optional<int> cables = std::nullopt;  // the closest design with at most so many instead
  std::string objective = "max";             // what is made small: max, rms (of the distances)
  // none; offer: those of the target are told of; detect: they are found, and orbits of cables stay
  // together; given: likewise, those that `generators` make.
  std::string symmetry = "offer";
  std::vector<SymmetryGenerator> generators{};
  // Cables only within these pairs of rods; [i, i] is within a rod. None: all pairs.
  std::optional<std::vector<std::array<int, 2>>> rod_pairs = std::nullopt;
  bool external = true;    // cables to the anchors, if there are any
  bool hand_over = false;  // pins: to cables to the anchors, once the pinned rods are designed
  std::optional<double> longest_cable = std::nullopt;
  // Where work can be shared out; none: as many as the machine has. The design is the same.
  std::optional<int> threads = std::nullopt;
  // Weights of the sparsity term, tried in this order (section 5.3).
  std::vector<double> sparsity_weights{0, 1, 10, 100, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};
  double spring_stiffness = 100;   // factor f of k = f E c^2 / L (section 5.1)
  double greedy_threshold = 5e-6;  // factor f of the threshold f L n (section 5.2)
};

struct Scene {
  std::string name;
  std::string source;  // its file, with which errors begin
  std::string length_unit = "cm";
  std::string force_unit = "N";
  std::vector<SceneRod> rods;
  Eigen::Matrix3Xd anchors = Eigen::Matrix3Xd(3, 0);
  std::vector<Pin> pinned;
  std::vector<PointLoad> point_loads;
  std::vector<LineLoad> line_loads;  // the rods' weights
  bool planar = false;               // all z coordinates are the same and stay so
  DesignSettings design;
};

// Reads a TOML scene and the curve files it names (relative to its folder). All indices, ranges and
// sizes are valid in what it returns. Errors: "file:line", with the key; an unknown key is one and
// comes with the key that is probably meant, or those known there.
core::Expected<Scene> read_scene(const std::filesystem::path& path);

// Why settings.hessian cannot go with settings.optimizer; nullopt when it can.
std::optional<std::string> hessian_problem(const DesignSettings& settings);

// The scene of bare curves (as from read_curves) with every default. `source` is the curves' file:
// errors begin with it, and the scene is named after it.
core::Expected<Scene> scene_of_curves(std::vector<geometry::Polyline> curves,
                                      const std::filesystem::path& source);

}  // namespace tencer::io
