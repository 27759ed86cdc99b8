// Small scenes, and what holds of every finished design.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <string>
#include <string_view>
#include <tencer/curves/analytic.hpp>
#include <tencer/geometry/arc_length.hpp>
#include <tencer/io/design.hpp>
#include <tencer/io/scene.hpp>
#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/prepare.hpp>
#include <vector>

namespace tencer {

inline model::Scene scene_of(const std::vector<geometry::Polyline>& curves) {
  auto scene = io::scene_of_curves(curves, "small.obj");
  REQUIRE(scene);
  scene->design.effort = 1;  // what is looked at here holds of any design
  return *std::move(scene);
}

inline model::Scene scene_at(const std::filesystem::path& path) {
  auto scene = io::read_scene(path);
  if (!scene) FAIL(scene.error().text());
  return *std::move(scene);
}

inline model::Scene trefoil_scene(int vertices = 40) {
  return scene_of({curves::trefoil(curves::TrefoilForm::hypotrochoid, 198, vertices)});
}

// Held in shape by one or two cables: the smallest design there is.
inline model::Scene ellipse_scene(int vertices = 30) {
  return scene_of({curves::ellipse(32.5, 25, vertices)});
}

// Gives a rod another target, with as many vertices.
inline void retarget(model::Scene& scene, std::size_t rod, const Eigen::Matrix3Xd& points) {
  scene.target.points[rod] = points;
  scene.structure.rods[rod].rest_lengths = geometry::edge_lengths(target_curve(scene, rod));
}

// An optimizer of the build by its name.
inline model::Optimizer optimizer_named(const std::string& name) {
  const auto optimizer = model::named<model::Optimizer>(name);
  REQUIRE(optimizer);
  return *optimizer;
}

inline pipeline::Prepared prepared_of(const model::Scene& scene) {
  auto prepared = pipeline::prepare(scene);
  if (!prepared) FAIL(prepared.error().text());
  return *std::move(prepared);
}

inline model::Design designed(const model::Scene& scene, const pipeline::RunOptions& options = {}) {
  auto design = pipeline::design(scene, options);
  if (!design) FAIL(design.error().text());
  return *std::move(design);
}

inline std::string error_of(const model::Scene& scene, const pipeline::RunOptions& options = {}) {
  const auto design = pipeline::design(scene, options);
  return design ? "no error" : design.error().text();
}

inline Eigen::Vector3d end_point(const model::Design& design, const springs::End& end) {
  if (const auto* anchor = std::get_if<springs::AtAnchor>(&end))
    return design.structure.anchors.col(anchor->anchor);
  const auto& on_rod = std::get<springs::OnRod>(end);
  const der::Rod& rod = design.structure.rods[on_rod.rod];
  const Eigen::Matrix3Xd& pose = design.pose[on_rod.rod];
  const auto at = geometry::ArcLength(rod.rest_lengths, rod.closed).locate(on_rod.s);
  return (1 - at.t) * pose.col(at.edge) + at.t * pose.col((at.edge + 1) % pose.cols());
}

inline double span(const model::Design& design, const springs::Cable& cable) {
  return (end_point(design, cable.a) - end_point(design, cable.b)).norm();
}

// Distance of the pose to the target in percent of the bounding-box diagonal, largest and root mean
// square, as they lie in the file.
inline model::DesignError distance(const model::Design& design) {
  Eigen::AlignedBox3d box;
  double largest = 0;
  double sum = 0;
  Eigen::Index vertices = 0;
  for (std::size_t r = 0; r < design.target.size(); ++r) {
    for (const auto& point : design.target[r].colwise()) box.extend(Eigen::Vector3d(point));
    const Eigen::RowVectorXd apart = (design.pose[r] - design.target[r]).colwise().norm();
    largest = std::max(largest, apart.maxCoeff());
    sum += apart.squaredNorm();
    vertices += apart.size();
  }
  const double percent = 100 / box.diagonal().norm();
  return {percent * largest, percent * std::sqrt(sum / static_cast<double>(vertices))};
}

// Lengths and tensions are those of the pose, the errors those of pose and target, and the trace
// leads to the result.
inline void check_consistent(const model::Design& design) {
  REQUIRE(design.error);
  REQUIRE(design.certificate);
  const auto& cables = design.structure.cables;
  REQUIRE(design.built.size() == cables.size());
  for (std::size_t c = 0; c < cables.size(); ++c) {
    const auto& [length, tension] = design.built[c];
    CHECK(length == Approx(span(design, cables[c])).epsilon(1e-9));
    CHECK(tension > 0);
    REQUIRE(cables[c].stiffness > 0);
    // Stiff springs are hardly longer than at rest: their extension has lost digits.
    const double extension = length - cables[c].rest_length;
    CHECK(tension == Approx(cables[c].stiffness * extension)
                         .epsilon(1e-6)
                         .margin(1e-12 * cables[c].stiffness * length));
  }
  CHECK(design.error->max_percent ==
        Approx(distance(design).max_percent).epsilon(1e-6).margin(1e-9));
  CHECK(design.error->rms_percent ==
        Approx(distance(design).rms_percent).epsilon(1e-6).margin(1e-9));

  REQUIRE_FALSE(design.trace.empty());
  CHECK(design.trace.back().cables == static_cast<int>(cables.size()));
  for (std::size_t i = 0; i < design.trace.size(); ++i) {
    const model::StageRow& row = design.trace[i];
    CAPTURE(row.stage);
    CHECK(std::isfinite(row.seconds));
    CHECK(row.seconds > 0);
    CHECK(std::isfinite(row.max_percent));
    CHECK(row.max_percent >= row.rms_percent);
    if (!design.complete()) continue;
    // Within an elimination, what stands may have more cables than what does not.
    CHECK(row.cables <= design.trace.front().cables);
    if (i > 0 && row.stage != "settle" && row.stage != "fit" &&
        row.stage != design.trace[i - 1].stage)
      CHECK(row.cables <= design.trace[i - 1].cables);
  }
}

}  // namespace tencer
