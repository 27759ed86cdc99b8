#include "mends.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <tencer/geometry/frame.hpp>
#include <utility>

namespace tencer::pipeline {
namespace {

Eigen::Matrix3Xd all_points(const model::Scene& scene) {
  Eigen::Index count = 0;
  for (const auto& points : scene.target.points) count += points.cols();
  Eigen::Matrix3Xd all(3, count);
  Eigen::Index at = 0;
  for (const auto& points : scene.target.points) {
    all.middleCols(at, points.cols()) = points;
    at += points.cols();
  }
  return all;
}

// The points of a curve averaged along it, as far as `reach`, a length; ends stay where they are.
geometry::Polyline smoothed(const geometry::Polyline& curve, double reach) {
  const Eigen::VectorXd lengths = geometry::edge_lengths(curve);
  const int n = curve.vertices();
  geometry::Polyline result = curve;
  for (int i = 0; i < n; ++i) {
    Eigen::Vector3d sum = curve.points.col(i);
    double weights = 1;
    double before = 0;
    double after = 0;
    // Pairs at the same number of steps to both sides: what leans neither way stays.
    for (int k = 1; 2 * k < n; ++k) {
      if (!curve.closed && (i < k || i + k >= n)) break;
      const int left = (i + n - k) % n;
      const int right = (i + k) % n;
      before += lengths[left];
      after += lengths[(right + n - 1) % n];
      if (before + after > 6 * reach) break;
      const double far = (before + after) / 2 / reach;
      const double weight = std::exp(-far * far / 2);
      sum += weight * (curve.points.col(left) + curve.points.col(right));
      weights += 2 * weight;
    }
    result.points.col(i) = sum / weights;
  }
  return result;
}

class Mends {
 public:
  Mends(const model::Scene& scene, const Trial& trial) : scene_(scene), trial_(trial) {}

  std::vector<model::Mend> take() { return std::move(mends_); }

  void lift_rules() {
    model::Scene changed = scene_;
    if (scene_.rules.pairs) {
      changed.rules.pairs.reset();
      add("cables between all rods, and within them: without rod_pairs", changed);
    }
    if (!scene_.rules.forbidden.empty()) {
      changed = scene_;
      changed.rules.forbidden.clear();
      add("cables tied anywhere: without forbidden_arcs and forbidden_vertices", changed);
    }
    if (std::isfinite(scene_.rules.max_cable_length)) {
      changed = scene_;
      changed.rules.max_cable_length = std::numeric_limits<double>::infinity();
      add("cables of any length: without longest_cable", changed);
    }
  }

  void anchor() {
    model::Scene changed = scene_;
    if (scene_.structure.anchors.cols() > 0) {
      if (scene_.rules.external) return;
      changed.rules.external = true;
      add("cables to the anchors: external = true", changed);
      return;
    }
    constexpr double margin = 0.1;  // of the diagonal, as a scene's frame has it
    changed.structure.anchors =
        geometry::enclosing_frame(geometry::FrameShape::cube, all_points(scene_),
                                  margin * size().norm(), scene_.structure.planar);
    changed.rules.external = true;
    add("cables to a frame about the rods: frame = {shape = \"cube\"}", changed);
  }

  void flatten() {
    constexpr double flat = 1e-6;  // of the diagonal
    const bool loaded =
        !scene_.structure.point_loads.empty() || !scene_.structure.line_loads.empty();
    if (scene_.structure.planar || loaded || size().z() > flat * size().norm()) return;
    model::Scene changed = scene_;
    changed.structure.planar = true;
    for (auto& rod : changed.target.points) rod.row(2).setConstant(scene_.target.points[0](2, 0));
    add("rods that cannot leave their plane, on a board or between two panes: planar = true",
        changed);
  }

  // More and more, until it helps; else the last is told.
  void smooth() {
    const auto& rods = scene_.structure.rods;
    const bool bent = std::ranges::any_of(
        rods, [](const der::Rod& rod) { return rod.rest_curvature.size() > 0; });
    // Places along the rods would no longer be the same.
    if (bent || !scene_.structure.pins.empty() || !scene_.rules.forbidden.empty()) return;
    const double diagonal = size().norm();
    std::optional<model::Mend> last;
    for (const double part : {0.01, 0.02, 0.04}) {
      model::Scene changed = scene_;
      double moved = 0;
      for (std::size_t r = 0; r < rods.size(); ++r) {
        const geometry::Polyline curve =
            smoothed(target_curve(scene_, r), part * rods[r].rest_lengths.sum());
        moved =
            std::max(moved, (curve.points - scene_.target.points[r]).colwise().norm().maxCoeff());
        changed.structure.rods[r].rest_lengths = geometry::edge_lengths(curve);
        changed.target.points[r] = curve.points;
      }
      std::ostringstream change;
      change.precision(2);
      change << "curves smoothed over " << 100 * part << " % of their length, which moves them by "
             << 100 * moved / diagonal << " % of their size";
      if (auto mend = tried(change.str(), changed)) last = std::move(mend);
      if (last && last->helps) break;
    }
    if (last) mends_.push_back(std::move(*last));
  }

 private:
  Eigen::Vector3d size() const {
    const Eigen::Matrix3Xd points = all_points(scene_);
    return points.rowwise().maxCoeff() - points.rowwise().minCoeff();
  }

  std::optional<model::Mend> tried(const std::string& change, const model::Scene& changed) const {
    const auto percent = trial_(changed);
    if (!percent) return std::nullopt;
    return model::Mend{
        .change = change, .helps = *percent <= scene_.design.max_error, .percent = *percent};
  }

  void add(const std::string& change, const model::Scene& changed) {
    if (auto mend = tried(change, changed)) mends_.push_back(std::move(*mend));
  }

  const model::Scene& scene_;
  const Trial& trial_;
  std::vector<model::Mend> mends_;
};

}  // namespace

std::vector<model::Mend> try_mends(const model::Scene& scene, const Trial& trial) {
  Mends mends(scene, trial);
  mends.lift_rules();
  mends.anchor();
  mends.flatten();
  mends.smooth();
  return mends.take();
}

}  // namespace tencer::pipeline
