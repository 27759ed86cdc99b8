#include "picture.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/core/words.hpp>
#include <tencer/geometry/measure.hpp>
#include <tencer/model/cable_lines.hpp>
#include <vector>

#include "axes.hpp"

namespace tencer::app {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double picture_width = 800;  // without the margin; the height follows
constexpr double margin = 40;
constexpr double rod_width = 9;
constexpr double gap = 3.5;  // on each side of a rod that passes over another
constexpr double cable_width = 2.2;
constexpr int cable_pieces = 24;  // each with its own depth

std::string number(double value) {
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 1);
  return {text.data(), end.ptr};
}

Eigen::Matrix3Xd all_points(const model::Design& design) {
  const Eigen::Matrix3Xd& anchors = design.structure.anchors;
  Eigen::Index count = anchors.cols();
  for (const auto& pose : design.pose) count += pose.cols();
  Eigen::Matrix3Xd points(3, count);
  Eigen::Index at = 0;
  for (const auto& pose : design.pose) {
    points.middleCols(at, pose.cols()) = pose;
    at += pose.cols();
  }
  points.rightCols(anchors.cols()) = anchors;
  return points;
}

// From the design's coordinates to the drawing's: x right, y down, z towards the reader, with a
// mild perspective.
struct View {
  Matrix3d rotation;
  Vector3d centre;
  double radius = 0;  // of the points about the centre
  double scale = 1;
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();

  double magnification(const Vector3d& turned) const { return 4 / (4 - turned.z() / radius); }

  Vector3d operator()(const Vector3d& point) const {
    const Vector3d turned = rotation * (point - centre);
    const double larger = magnification(turned) * scale;
    return {larger * turned.x() + offset.x(), -larger * turned.y() + offset.y(), turned.z()};
  }
  double magnification_at(double depth) const { return magnification({0, 0, depth}); }
};

struct Frame {
  View view;
  double width = 0;
  double height = 0;
};

Frame frame_of(const Eigen::Matrix3Xd& points) {
  View view{.rotation = oblique_axes(points),
            .centre = (points.rowwise().minCoeff() + points.rowwise().maxCoeff()) / 2};
  view.radius = (points.colwise() - view.centre).colwise().norm().maxCoeff();
  core::require(std::isfinite(view.radius) && view.radius > 0,
                "picture_svg: needs a rod with finite coordinates and some extent");
  Eigen::Matrix3Xd drawn(3, points.cols());
  const auto project = [&] {
    for (Eigen::Index i = 0; i < points.cols(); ++i) drawn.col(i) = view(points.col(i));
  };
  project();
  const Vector3d extent = drawn.rowwise().maxCoeff() - drawn.rowwise().minCoeff();
  view.scale = picture_width / std::max(extent.x(), extent.y());
  project();
  const Vector3d corner = drawn.rowwise().minCoeff();
  view.offset = Eigen::Vector2d(margin, margin) - corner.head<2>();
  const Vector3d size = drawn.rowwise().maxCoeff() - corner;
  return {view, size.x() + 2 * margin, size.y() + 2 * margin};
}

// A straight stroke, or an anchor's square at a point (then a = b).
struct Piece {
  Vector3d a;
  Vector3d b;
  int rod = -1;  // -1: of a cable
  bool anchor = false;

  double depth() const { return (a.z() + b.z()) / 2; }
};

void add_rod(const geometry::Polyline& curve, int rod, const View& view,
             std::vector<Piece>& pieces) {
  for (int i = 0; i < curve.edges(); ++i)
    pieces.push_back(
        {view(curve.points.col(i)), view(curve.points.col((i + 1) % curve.vertices())), rod});
}

std::vector<Piece> pieces_of(const model::Design& design, const View& view) {
  const model::Structure& structure = design.structure;
  std::vector<Piece> pieces;
  for (std::size_t r = 0; r < structure.rods.size(); ++r)
    add_rod(model::pose_curve(design, r), static_cast<int>(r), view, pieces);
  for (const geometry::Polyline& line : model::cable_lines(design)) {
    const Vector3d a = line.points.col(0);
    const Vector3d b = line.points.col(1);
    const auto at = [&](int i) { return view(a + (b - a) * i / cable_pieces); };
    for (int i = 0; i < cable_pieces; ++i) pieces.push_back({at(i), at(i + 1)});
  }
  for (const auto& anchor : structure.anchors.colwise())
    pieces.push_back({view(anchor), view(anchor), -1, true});
  std::ranges::stable_sort(pieces, {}, &Piece::depth);
  return pieces;
}

std::string line(const Piece& piece, const std::string& style, double width) {
  return "<path class=\"" + style + "\" stroke-width=\"" + number(width) + "\" d=\"M" +
         number(piece.a.x()) + " " + number(piece.a.y()) + "L" + number(piece.b.x()) + " " +
         number(piece.b.y()) + "\"/>\n";
}

std::string drawing(const Piece& piece, double magnification) {
  if (piece.anchor) {
    constexpr double side = 16;
    return "<rect class=\"t-anchor\" x=\"" + number(piece.a.x() - side / 2) + "\" y=\"" +
           number(piece.a.y() - side / 2) + "\" width=\"" + number(side) + "\" height=\"" +
           number(side) + "\"/>\n";
  }
  if (piece.rod < 0) return line(piece, "t-cable", cable_width * magnification);
  const double width = rod_width * magnification;
  return line(piece, "t-gap", width + 2 * gap) +
         line(piece, "t-rod t-rod" + std::to_string(piece.rod % 6), width);
}

constexpr const char* styles = R"(<style>
.t-paper { fill: #ffffff } .t-gap { stroke: #ffffff }
.t-rod, .t-cable { stroke-linecap: round }
.t-rod0 { stroke: #3f7cc4 } .t-rod1 { stroke: #2fa37c } .t-rod2 { stroke: #8a68c8 }
.t-rod3 { stroke: #64859e } .t-rod4 { stroke: #b99338 } .t-rod5 { stroke: #b7648c }
.t-cable { stroke: #d9481c } .t-anchor { fill: #6b7682 }
@media (prefers-color-scheme: dark) {
.t-paper { fill: #11161c } .t-gap { stroke: #11161c } .t-cable { stroke: #ff8a5c }
}
</style>
)";

// What all drawings begin with, and the strokes of one.
std::string drawn(const Frame& frame, const std::string& title, const std::vector<Piece>& pieces) {
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " +
                    number(frame.width) + " " + number(frame.height) + "\" role=\"img\">\n";
  svg += "<title>" + title + "</title>\n";
  svg += styles;
  svg += "<rect class=\"t-paper\" width=\"" + number(frame.width) + "\" height=\"" +
         number(frame.height) + "\"/>\n<g fill=\"none\">\n";
  for (const Piece& piece : pieces)
    svg += drawing(piece, frame.view.magnification_at(piece.depth()));
  return svg + "</g>\n</svg>\n";
}

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
  std::vector<Vector3d> tails;
  std::vector<Vector3d> tips;
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

// A shaft and two strokes of a head, in the drawing's coordinates.
void add_arrow(const Vector3d& tail, const Vector3d& tip, std::vector<Piece>& pieces) {
  constexpr double longest_head = 9;
  const Vector3d along = tail - tip;
  const double length = along.head<2>().norm();
  if (!(length > 0)) return;
  pieces.push_back({tail, tip});
  const double part = std::min(longest_head, length / 2) / length;
  for (const double side : {-0.5, 0.5}) {
    const Vector3d across(-along.y(), along.x(), 0);
    pieces.push_back({tip, tip + part * (along + side * across)});
  }
}

}  // namespace

std::string picture_svg(const model::Design& design) {
  core::require(!design.structure.rods.empty(), "picture_svg: needs at least one rod");
  const Frame frame = frame_of(all_points(design));
  return drawn(frame,
               "Rods held in shape by " +
                   core::counted(static_cast<int>(design.structure.cables.size()), "cable"),
               pieces_of(design, frame.view));
}

std::string picture_svg(const model::Feasibility& feasibility) {
  core::require(!feasibility.targets.empty(), "picture_svg: needs at least one rod");
  const Arrows arrows = arrows_of(feasibility);
  Eigen::Matrix3Xd points(3, 2 * arrows.tails.cols());
  points << arrows.tails, arrows.tips;
  const Frame frame = frame_of(points);
  std::vector<Piece> pieces;
  for (std::size_t r = 0; r < feasibility.targets.size(); ++r)
    add_rod(feasibility.targets[r], static_cast<int>(r), frame.view, pieces);
  for (Eigen::Index i = 0; i < arrows.tails.cols(); ++i)
    add_arrow(frame.view(arrows.tails.col(i)), frame.view(arrows.tips.col(i)), pieces);
  std::ranges::stable_sort(pieces, {}, &Piece::depth);
  std::string title = feasibility.apart.empty()
                          ? "How rods move with all cables tied that are allowed"
                          : "How rods that lie apart are drawn together";
  if (arrows.times > 1) title += ", " + number(arrows.times) + " times as far";
  return drawn(frame, title, pieces);
}

}  // namespace tencer::app
