#include "drawing/motion_picture.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <tencer/core/error.hpp>
#include <tencer/geometry/measure.hpp>
#include <tencer/model/units.hpp>
#include <vector>

#include "drawing/layout.hpp"

namespace tencer::app {
namespace {

using Eigen::Vector2d;

// The motions as they are drawn.
struct Arrows {
  Eigen::Matrix3Xd tails{};
  Eigen::Matrix3Xd tips{};
  double times = 1;  // enlarged so much
};

Arrows arrows_of(const model::Feasibility& feasibility) {
  constexpr int most = 60;         // of a rod
  constexpr double visible = 0.1;  // of the size: the largest is at least so long
  double largest = 0;
  for (const auto& motion : feasibility.motions)
    largest = std::max(largest, motion.colwise().norm().maxCoeff());
  const double size = geometry::bounding_box_diagonal(feasibility.targets);
  Arrows arrows;
  if (largest > 0) arrows.times = std::max(1.0, visible * size / largest);
  std::vector<Eigen::Vector3d> tails;
  std::vector<Eigen::Vector3d> tips;
  for (std::size_t r = 0; r < feasibility.targets.size(); ++r) {
    const Eigen::Matrix3Xd& points = feasibility.targets[r].points;
    const Eigen::Index step = (points.cols() + most - 1) / most;
    for (Eigen::Index i = 0; i < points.cols(); i += step) {
      tails.emplace_back(points.col(i));
      tips.emplace_back(points.col(i) + arrows.times * feasibility.motions[r].col(i));
    }
  }
  arrows.tails.resize(3, static_cast<Eigen::Index>(tails.size()));
  arrows.tips = arrows.tails;
  for (std::size_t i = 0; i < tails.size(); ++i) {
    arrows.tails.col(static_cast<Eigen::Index>(i)) = tails[i];
    arrows.tips.col(static_cast<Eigen::Index>(i)) = tips[i];
  }
  return arrows;
}

// A shaft and a head.
void draw_arrow(Canvas& canvas, const Path& line) {
  constexpr double longest_head = 1.8;
  const Vector2d tail = line.col(0);
  const Vector2d tip = line.col(1);
  const Vector2d along = tip - tail;
  const double length = along.norm();
  if (!(length > 0)) return;
  canvas.line(tail.x(), tail.y(), tip.x(), tip.y(), {accent, 0.3});
  const Vector2d back = std::min(longest_head, length / 2) / length * along;
  const Vector2d across(-0.35 * back.y(), 0.35 * back.x());
  Path head(2, 3);
  head << tip, tip - back + across, tip - back - across;
  canvas.area(head, accent);
}

// The targets, and in place of cables the arrows.
Solid solid_of(const model::Feasibility& feasibility, const Arrows& arrows) {
  const double mm = 1000 * model::metres(feasibility.length_unit);
  Solid solid{.rods = static_cast<int>(feasibility.targets.size())};
  for (const geometry::Polyline& target : feasibility.targets)
    solid.curves.push_back(smooth(target));
  for (Eigen::Index i = 0; i < arrows.tails.cols(); ++i) {
    geometry::Polyline arrow{Eigen::Matrix3Xd(3, 2), false};
    arrow.points << arrows.tails.col(i), arrows.tips.col(i);
    solid.curves.push_back(arrow);
  }
  for (geometry::Polyline& curve : solid.curves) curve.points *= mm;
  solid.ends_on.resize(solid.cables());
  return solid;
}

std::string times_in_words(double times) {
  std::ostringstream words;
  words << std::setprecision(3) << times;
  return words.str();
}

}  // namespace

std::string motion_picture(const model::Feasibility& feasibility) {
  core::require(!feasibility.targets.empty(), "motion_picture: needs at least one rod");
  const Arrows arrows = arrows_of(feasibility);
  const Solid solid = solid_of(feasibility, arrows);
  PictureOptions options{.caption = feasibility.apart.empty()
                                        ? "How rods move with all cables tied that are allowed"
                                        : "How rods that lie apart are drawn together",
                         .numbers = false};
  if (arrows.times > 1) options.caption += ", " + times_in_words(arrows.times) + " times as far";
  const Layout layout(solid, options);
  Look look = layout.look();
  look.tied.assign(solid.cables(), false);  // they are drawn as arrows
  const auto draw_all = [&](Canvas& canvas) {
    layout.draw_all(canvas, look);
    for (int i = 0; i < solid.cables(); ++i)
      draw_arrow(canvas, layout.line_in_first(solid.rods + i));
  };
  return svg_drawing(layout.size().x(), layout.size().y(), options.caption, draw_all);
}

}  // namespace tencer::app
