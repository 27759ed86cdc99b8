// The front door: curves in, cables out.
//
//   const auto curves = tencer::read_curves("knot.obj");
//   const auto design = tencer::design(*curves, {.max_error = 1.0});
//   std::cout << design->full_report();
//
// docs/embedding.md has a whole program. Everything is in the units of the curves. Functions may be
// called from several threads at once; one call uses DesignOptions::threads of its own.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/der/section.hpp>
#include <tencer/geometry/polyline.hpp>
#include <tencer/model/design.hpp>
#include <tencer/model/scene.hpp>
#include <tencer/pipeline/design.hpp>
#include <vector>

namespace tencer {

// A target curve: points (3 x n) and whether it is closed.
using Curve = geometry::Polyline;

// The curves of an .obj, .csv, .xyz, .txt or .json file; errors name the file and the line.
core::Expected<std::vector<Curve>> read_curves(const std::filesystem::path& file);

// The section of a round rod: Young's modulus in force_unit / length_unit^2, radius in length_unit.
der::Section round_rod(double youngs_modulus, double radius, double poisson = 0.3);

// What is not set is as the scene says, or has the default that docs/scene.md tells under the same
// name.
struct DesignOptions {
  std::optional<std::string> length_unit{};  // of bare curves: mm, cm (the default), m
  std::optional<std::string> force_unit{};   // of bare curves: mN, N (the default), kN
  // Of all rods; by default round ones of a radius that their bends allow.
  std::optional<der::Section> section{};
  std::optional<std::string> material{};  // of rods that say none: "ash"; glass fibre by default
  std::optional<Eigen::Matrix3Xd> anchors{};  // 3 x k, fixed points for cables
  std::optional<double> max_error{};          // percent of the target's bounding-box diagonal
  std::optional<int> cables{};                // the closest design with at most so many instead
  std::optional<model::Method> method{};
  std::optional<model::Optimizer> optimizer{};
  std::optional<model::SecondDerivatives> hessian{};
  std::optional<model::Measure> objective{};
  std::optional<model::SymmetryUse> symmetry{};
  std::optional<std::vector<model::RodPair>> rod_pairs{};
  std::optional<double> longest_cable{};
  std::optional<double> length_error{};      // cables are cut to this
  std::optional<double> attachment_error{};  // and tied to this along their rods
  std::optional<model::Allowance> max_deviation{};
  std::optional<int> threads{};
  std::optional<double> time{};  // seconds after which the search ends with the best it has
  std::optional<int> effort{};   // of the search: 1 quick, 2, 3 thorough
  double resolution = 1.0;       // vertices of every rod, times what the curves have
  pipeline::RunOptions run{};

  // What is wrong, beginning with the name of the field; not set: nothing.
  [[nodiscard]] std::optional<std::string> problem() const;
  // Throws std::invalid_argument with it.
  void validate() const;
};

// The scene with the options in place of what it says. A maximal error takes the place of the
// scene's number of cables. Errors: options that are wrong by themselves, or with this scene.
core::Expected<model::Scene> with_options(model::Scene scene, const DesignOptions& options);

// The design of bare curves, of a curve or scene file (.toml), of a scene. Its reports say whether
// it is complete (Design::complete()), and if not, why. Errors are bad input: they name the option,
// the file and line, or the scene's key.
core::Expected<model::Design> design(const std::vector<Curve>& curves,
                                     const DesignOptions& options = {});
core::Expected<model::Design> design(const std::filesystem::path& file,
                                     const DesignOptions& options = {});
core::Expected<model::Design> design(const model::Scene& scene, const DesignOptions& options = {});

// The scene of a curve or scene file.
core::Expected<model::Scene> read_scene(const std::filesystem::path& file);

// Writes a design file (design.json); not set: done.
[[nodiscard]] std::optional<core::Error> write_design(const std::filesystem::path& file,
                                                      const model::Design& design);

}  // namespace tencer
