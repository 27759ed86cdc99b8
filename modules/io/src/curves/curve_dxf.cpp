#include "curves/curve_dxf.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tencer/geometry/spline.hpp>
#include <utility>

#include "curves/drawing.hpp"
#include "curves/dxf_entities.hpp"
#include "curves/dxf_units.hpp"
#include "text/bad_input.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180;

// The axes in which a flat entity's coordinates are (DXF's arbitrary axis algorithm).
Eigen::Matrix3d axes_of(const DxfEntity& entity) {
  const Vector3d given(entity.number(210), entity.number(220), entity.number(230, 1));
  if (!(given.norm() > 0)) fail(entity.where, "its extrusion direction (210, 220, 230) is zero");
  const Vector3d normal = given.normalized();
  constexpr double near = 1.0 / 64;
  const bool upright = std::abs(normal.x()) < near && std::abs(normal.y()) < near;
  Eigen::Matrix3d axes;
  axes.col(0) = (upright ? Vector3d::UnitY() : Vector3d::UnitZ()).cross(normal).normalized();
  axes.col(1) = normal.cross(axes.col(0));
  axes.col(2) = normal;
  return axes;
}

Piece in_axes(Piece piece, const Eigen::Matrix3d& axes) {
  piece.at = [at = std::move(piece.at), axes](double t) -> Vector3d { return axes * at(t); };
  return piece;
}

Stroke circle(const DxfEntity& entity, bool whole) {
  const double radius = entity.number(40);
  if (!(radius > 0)) fail(entity.where, "expected a positive radius");
  const double start = whole ? 0 : entity.number(50) * degree;
  double sweep = whole ? 2 * std::numbers::pi : entity.number(51) * degree - start;
  while (sweep <= 0) sweep += 2 * std::numbers::pi;
  return {{in_axes(arc(entity.point(10), {radius, 0, 0}, {0, radius, 0}, start, sweep),
                   axes_of(entity))},
          whole,
          entity.where};
}

Stroke ellipse(const DxfEntity& entity) {
  const Vector3d major = entity.point(11);
  const Vector3d normal = axes_of(entity).col(2);
  const double start = entity.number(41);
  const double turn = 2 * std::numbers::pi;
  double sweep = entity.number(42, turn) - start;
  while (sweep <= 0) sweep += turn;
  return {{arc(entity.point(10), major, entity.number(40, 1) * normal.cross(major), start, sweep)},
          std::abs(sweep - turn) < 1e-9,
          entity.where};
}

struct Vertex {
  Vector3d point = Vector3d::Zero();
  double bulge = 0.0;  // the tangent of a quarter of the angle of the arc to the next
};

Piece to_next(const Vertex& from, const Vector3d& to) {
  const double b = from.bulge;
  if (b == 0) return line(from.point, to);
  const Vector3d chord = to - from.point;
  const Vector3d normal(-chord.y(), chord.x(), 0);
  const Vector3d center = (from.point + to) / 2 + (1 - b * b) / (4 * b) * normal;
  const Vector3d x = from.point - center;
  return arc(center, x, {-x.y(), x.x(), 0}, 0, 4 * std::atan(b));
}

std::vector<Stroke> polyline(const std::vector<Vertex>& vertices, bool closed,
                             const Eigen::Matrix3d& axes, const std::string& where) {
  Stroke stroke{.closed = closed, .where = where};
  const std::size_t n = vertices.size();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
    const Vector3d& next = vertices[(i + 1) % n].point;
    if (vertices[i].point != next)
      stroke.pieces.push_back(in_axes(to_next(vertices[i], next), axes));
  }
  if (stroke.pieces.empty()) return {};
  return {std::move(stroke)};
}

std::vector<Stroke> light_polyline(const DxfEntity& entity) {
  std::vector<Vertex> vertices;
  const double height = entity.number(38);
  for (const auto& value : entity.values) {
    const int code = value.first;
    const auto number = [&] { return DxfEntity{"", entity.where, {value}}.number(code); };
    if (code == 10) vertices.push_back({{number(), 0, height}});
    if (vertices.empty()) continue;
    if (code == 20) vertices.back().point.y() = number();
    if (code == 42) vertices.back().bulge = number();
  }
  return polyline(vertices, entity.flags(70) & 1, axes_of(entity), entity.where);
}

// The entities VERTEX from `at` on, up to SEQEND, are the polyline's.
std::vector<Stroke> heavy_polyline(const DxfEntity& entity, const std::vector<DxfEntity>& all,
                                   std::size_t& at) {
  constexpr int three_dimensional = 8, mesh = 16 | 64, control_point = 16;
  const int flags = entity.flags(70);
  if (flags & mesh) fail(entity.where, "is a mesh; export the curve alone");
  std::vector<Vertex> vertices;
  for (; at < all.size() && all[at].name == "VERTEX"; ++at)
    if (!(all[at].flags(70) & control_point))
      vertices.push_back({all[at].point(10), all[at].number(42)});
  if (at < all.size() && all[at].name == "SEQEND") ++at;
  return polyline(vertices, flags & 1,
                  flags & three_dimensional ? Eigen::Matrix3d::Identity() : axes_of(entity),
                  entity.where);
}

Eigen::Matrix3Xd matrix(const std::vector<Vector3d>& points) {
  Eigen::Matrix3Xd result(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) result.col(i) = points[i];
  return result;
}

// One that is known by points on it only: the smooth curve through them.
Stroke through_points(const DxfEntity& entity, const std::vector<Vector3d>& points) {
  constexpr int vertices_each = 10;
  if (points.size() < 2)
    fail(entity.where, "holds neither control points nor points to go through");
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!((points[i] - points[i - 1]).norm() > 0))
      fail(entity.where, "goes through a point twice in a row");
  const auto smooth = geometry::sample_spline(
      {matrix(points), false}, vertices_each * static_cast<int>(points.size() - 1) + 1);
  Stroke stroke{.where = entity.where};
  for (int i = 1; i < smooth.vertices(); ++i)
    stroke.pieces.push_back(line(smooth.points.col(i - 1), smooth.points.col(i)));
  return stroke;
}

Stroke spline(const DxfEntity& entity) {
  const auto control = entity.points(10);
  if (control.empty()) return through_points(entity, entity.points(11));
  Nurbs nurbs{.degree = entity.flags(71), .control = matrix(control), .knots = entity.numbers(40)};
  const auto weights = entity.numbers(41);
  nurbs.weights = Eigen::Map<const Eigen::VectorXd>(weights.data(), std::ssize(weights));
  if (!nurbs.knots.empty()) {
    nurbs.from = nurbs.knots.front();
    nurbs.to = nurbs.knots.back();
  }
  if (const char* wrong = problem(nurbs))
    fail(entity.where, std::string("this spline cannot be drawn: ") + wrong);
  return {pieces(nurbs), false, entity.where};
}

// Draws the entities of a file, blocks wherever they are inserted.
class DxfDrawing {
 public:
  explicit DxfDrawing(const DxfContent& content) : content_(content) {
    draw(content.entities, Eigen::Affine3d::Identity(), 0);
  }

  const std::vector<Stroke>& strokes() const { return strokes_; }
  int others() const { return others_; }

 private:
  void draw(const std::vector<DxfEntity>& entities, const Eigen::Affine3d& transform, int depth) {
    for (std::size_t at = 0; at < entities.size();) {
      const DxfEntity& entity = entities[at++];
      if (entity.name == "LINE")
        add(polyline({{entity.point(10)}, {entity.point(11)}}, false, Eigen::Matrix3d::Identity(),
                     entity.where),
            transform);
      else if (entity.name == "CIRCLE" || entity.name == "ARC")
        add({circle(entity, entity.name == "CIRCLE")}, transform);
      else if (entity.name == "ELLIPSE")
        add({ellipse(entity)}, transform);
      else if (entity.name == "LWPOLYLINE")
        add(light_polyline(entity), transform);
      else if (entity.name == "POLYLINE")
        add(heavy_polyline(entity, entities, at), transform);
      else if (entity.name == "SPLINE")
        add({spline(entity)}, transform);
      else if (entity.name == "INSERT")
        insert(entity, transform, depth);
      else
        ++others_;
    }
  }

  void add(std::vector<Stroke> strokes, const Eigen::Affine3d& transform) {
    for (Stroke& stroke : strokes) {
      for (Piece& piece : stroke.pieces)
        piece.at = [at = std::move(piece.at), transform](double t) -> Vector3d {
          return transform * at(t);
        };
      strokes_.push_back(std::move(stroke));
    }
  }

  // A block, perhaps several times in rows and columns.
  void insert(const DxfEntity& entity, const Eigen::Affine3d& above, int depth) {
    constexpr int deepest = 50;
    const auto block = content_.blocks.find(entity.text(2));
    if (block == content_.blocks.end()) {
      ++others_;
      return;
    }
    if (depth > deepest)
      fail(entity.where, "blocks are nested more than 50 deep, or in themselves");
    const Vector3d scale(entity.number(41, 1), entity.number(42, 1), entity.number(43, 1));
    if ((scale.array() == 0).any()) fail(entity.where, "its scale (41, 42, 43) is zero");
    const int columns = std::max(1, entity.flags(70));
    const int rows = std::max(1, entity.flags(71));
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        if (++inserts_ > most_inserts)
          fail(entity.where, "blocks are inserted more than 10000 times; draw the curves alone");
        Eigen::Affine3d own(axes_of(entity));
        own.translate(entity.point(10))
            .rotate(Eigen::AngleAxisd(entity.number(50) * degree, Vector3d::UnitZ()))
            .translate(Vector3d(column * entity.number(44), row * entity.number(45), 0))
            .scale(scale)
            .translate(-block->second.head.point(10));
        draw(block->second.entities, above * own, depth + 1);
      }
  }

  static constexpr int most_inserts = 10000;
  const DxfContent& content_;
  std::vector<Stroke> strokes_;
  int others_ = 0;
  int inserts_ = 0;
};

}  // namespace

CurveFile parse_dxf(std::string_view text, const std::string& file) {
  const DxfContent content = dxf_content(text, file);
  const DxfDrawing drawing(content);
  if (drawing.strokes().empty())
    fail(file,
         "the drawing holds no lines, arcs, polylines or splines" +
             std::string(drawing.others() > 0 ? ", only other things; export the curves themselves"
                                              : ""));
  CurveFile result;
  if (const auto unit = dxf_unit(content.units)) result.length_unit = std::string(*unit);
  add_strokes(drawing.strokes(), result);
  if (drawing.others() > 0)
    result.notes.push_back(file + ": what is no line, arc, polyline or spline is left out, " +
                           std::to_string(drawing.others()) + " of them");
  return result;
}

}  // namespace tencer::io
