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

inline io::Scene scene_of(std::vector<geometry::Polyline> curves) {
  auto scene = io::scene_of_curves(std::move(curves), "small.obj");
  REQUIRE(scene);
  scene->design.optimizer = pipeline::backends().front().name;
  // Few unknowns: second derivatives of the distance are cheap.
  scene->design.hessian = "gauss-newton";
  return *std::move(scene);
}

inline io::Scene scene_at(const std::filesystem::path& path) {
  auto scene = io::read_scene(path);
  if (!scene) FAIL(scene.error().text());
  return *std::move(scene);
}

inline io::Scene trefoil_scene(int vertices = 40) {
  return scene_of({curves::trefoil(curves::TrefoilForm::hypotrochoid, 198, vertices)});
}

// Held in shape by one or two cables: the smallest design there is.
inline io::Scene ellipse_scene(int vertices = 30) {
  return scene_of({curves::ellipse(32.5, 25, vertices)});
}

inline pipeline::Prepared prepared_of(const io::Scene& scene) {
  auto prepared = pipeline::prepare(scene);
  if (!prepared) FAIL(prepared.error().text());
  return *std::move(prepared);
}

inline io::Design designed(const io::Scene& scene, const pipeline::DesignOptions& options = {}) {
  auto design = pipeline::design(scene, options);
  if (!design) FAIL(design.error().text());
  return *std::move(design);
}

inline std::string error_of(const io::Scene& scene, const pipeline::DesignOptions& options = {}) {
  const auto design = pipeline::design(scene, options);
  return design ? "no error" : design.error().text();
}

inline Eigen::Vector3d end_point(const io::Design& design, const io::CableEnd& end) {
  if (end.anchor >= 0) return design.anchors.col(end.anchor);
  const io::DesignRod& rod = design.rods[end.rod];
  const auto at = geometry::ArcLength(rod.rest_lengths, rod.closed).locate(end.s);
  return (1 - at.t) * rod.pose.col(at.edge) + at.t * rod.pose.col((at.edge + 1) % rod.pose.cols());
}

inline double span(const io::Design& design, const io::DesignCable& cable) {
  return (end_point(design, cable.a) - end_point(design, cable.b)).norm();
}

inline bool is_external(const io::DesignCable& cable) {
  return cable.a.anchor >= 0 || cable.b.anchor >= 0;
}

// Distance of the pose to the target in percent of the bounding-box diagonal, largest and root mean
// square, as they lie in the file.
inline io::DesignError distance(const io::Design& design) {
  Eigen::AlignedBox3d box;
  double largest = 0;
  double sum = 0;
  Eigen::Index vertices = 0;
  for (const io::DesignRod& rod : design.rods) {
    for (const auto& point : rod.target.colwise()) box.extend(Eigen::Vector3d(point));
    const Eigen::RowVectorXd apart = (rod.pose - rod.target).colwise().norm();
    largest = std::max(largest, apart.maxCoeff());
    sum += apart.squaredNorm();
    vertices += apart.size();
  }
  const double percent = 100 / box.diagonal().norm();
  return {percent * largest, percent * std::sqrt(sum / static_cast<double>(vertices))};
}

// Lengths and tensions are those of the pose, the errors those of pose and target, and the trace
// leads to the result.
inline void check_consistent(const io::Design& design) {
  REQUIRE(design.error);
  REQUIRE(design.certificate);
  for (const io::DesignCable& cable : design.cables) {
    CHECK(cable.length == Approx(span(design, cable)).epsilon(1e-9));
    CHECK(cable.tension > 0);
    REQUIRE((cable.stiffness && cable.rest_length));
    // Stiff springs are hardly longer than at rest: their extension has lost digits.
    const double extension = cable.length - *cable.rest_length;
    CHECK(cable.tension == Approx(*cable.stiffness * extension)
                               .epsilon(1e-6)
                               .margin(1e-12 * *cable.stiffness * cable.length));
  }
  CHECK(design.error->max_percent ==
        Approx(distance(design).max_percent).epsilon(1e-6).margin(1e-9));
  CHECK(design.error->rms_percent ==
        Approx(distance(design).rms_percent).epsilon(1e-6).margin(1e-9));

  REQUIRE_FALSE(design.trace.empty());
  CHECK(design.trace.back().cables == static_cast<int>(design.cables.size()));
  for (std::size_t i = 0; i < design.trace.size(); ++i) {
    const io::TraceRow& row = design.trace[i];
    CAPTURE(row.stage);
    CHECK(std::isfinite(row.seconds));
    CHECK(row.seconds > 0);
    CHECK(std::isfinite(row.max_percent));
    CHECK(row.max_percent >= row.rms_percent);
    // While nothing is close enough, closer is better than fewer.
    if (i > 0 && row.stage != "settle" && design.status == io::DesignStatus::complete)
      CHECK(row.cables <= design.trace[i - 1].cables);
  }
}

}  // namespace tencer
