#include "drawing/drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tencer/core/names.hpp>
#include <tencer/fabricate/names.hpp>

#include "drawing/labels.hpp"

namespace tencer::app {
namespace {

using Eigen::Vector2d;

constexpr Colour plain_rod{0.70, 0.73, 0.76};

// On paper: what is drawn, with the gaps, and the words' places.
class Sketch {
 public:
  Sketch(Canvas& canvas, const Seen& seen, const Spot& spot, const Look& look)
      : canvas_(canvas), seen_(seen), spot_(spot), look_(look) {
    for (const Path& line : seen.lines()) lines_.push_back(on_paper(line, seen, spot));
  }

  // Returns how many names found no place.
  int draw() {
    find_strokes();
    draw_rods();
    for (int c = 0; c < seen_.solid().cables(); ++c) draw_cable(c);
    for (int r = 0; r < seen_.solid().rods && look_.starts; ++r) draw_start(r);
    draw_anchors();
    place_words();
    return left_out_;
  }

 private:
  bool is_rod(int curve) const { return curve < seen_.solid().rods; }
  bool drawn(int cable) const { return look_.tied.empty() || look_.tied[cable]; }
  bool visible(int curve) const { return is_rod(curve) || drawn(curve - seen_.solid().rods); }
  // One that is only there to be remembered.
  bool plain_cable(int curve) const {
    return look_.plain && !is_rod(curve) && curve - seen_.solid().rods != look_.new_cable;
  }
  double width(int curve) const { return is_rod(curve) ? look_.rod_width : look_.cable_width; }

  double along(const geometry::EdgePoint& at) const {
    const Eigen::VectorXd& lengths = lengths_[at.rod];
    return (1 - at.t) * lengths[at.edge] + at.t * lengths[at.edge + 1];
  }

  Spotted spotted(const geometry::EdgePoint& at) const {
    return {lines_[at.rod], lengths_[at.rod], along(at)};
  }

  // A cable meets its own rods where it is tied.
  bool is_tie(const fabricate::Crossing& c) const {
    constexpr double beside = 1.5;
    for (const auto& [cable, rod] : {std::pair(c.over, c.under), std::pair(c.under, c.over)}) {
      if (is_rod(cable.rod) || !is_rod(rod.rod)) continue;
      const auto& own = seen_.solid().ends_on[cable.rod - seen_.solid().rods];
      const double from_a = along(cable);
      const double from_b = lengths_[cable.rod].tail<1>()[0] - from_a;
      if (std::ranges::count(own, rod.rod) > 0 && std::min(from_a, from_b) < beside) return true;
    }
    return false;
  }

  void find_strokes() {
    const double below_rod = 0.42 * look_.rod_width;
    const double below_cable = 0.2 * look_.rod_width;
    const auto& curves = seen_.solid().curves;
    for (std::size_t i = 0; i < lines_.size(); ++i)
      lengths_.push_back(lengths_along(lines_[i], curves[i].closed));
    std::vector<std::vector<Gap>> gaps(lines_.size());
    for (const fabricate::Crossing& c : seen_.crossings()) {
      const bool under_thin_line = is_rod(c.under.rod) && !is_rod(c.over.rod);
      if (under_thin_line || !visible(c.over.rod) || plain_cable(c.under.rod) || is_tie(c))
        continue;
      const double clear = width(c.over.rod) / 2 + (is_rod(c.over.rod) ? below_rod : below_cable);
      gaps[c.under.rod].push_back(
          gap_under(spotted(c.over), spotted(c.under), clear, width(c.under.rod)));
    }
    for (std::size_t i = 0; i < lines_.size(); ++i)
      strokes_.push_back(strokes(lines_[i], curves[i].closed, std::move(gaps[i]), look_.rod_width));
  }

  // From the lowest to the highest, each with a little paper around it, which parts those that run
  // side by side.
  void draw_rods() {
    struct Drawn {
      int rod = 0;
      const Stroke* stroke = nullptr;
      double height = 0.0;
    };
    std::vector<Drawn> drawn;
    for (int r = 0; r < seen_.solid().rods; ++r)
      for (const Stroke& stroke : strokes_[r]) drawn.push_back({r, &stroke, height(r, stroke)});
    std::ranges::stable_sort(drawn, {}, &Drawn::height);
    for (const Drawn& one : drawn) {
      draw_rod(*one.stroke, is_ring(one.rod, *one.stroke),
               look_.plain ? plain_rod : rod_colour(one.rod));
    }
  }

  bool is_ring(int rod, const Stroke& stroke) const {
    return seen_.solid().curves[rod].closed && stroke.from == 0 &&
           stroke.to == lengths_[rod].tail<1>()[0];
  }

  void draw_rod(const Stroke& stroke, bool ring, const Colour& colour) {
    const double paper = 0.15 * look_.rod_width;  // on either side
    if (ring) {
      canvas_.border(stroke.line, {white, look_.rod_width + 2 * paper});
      canvas_.border(stroke.line, {colour, look_.rod_width});
    } else {
      const Path shape = outline(stroke, look_.rod_width);
      canvas_.border(shape, {white, 2 * paper});
      canvas_.area(shape, colour);
    }
  }

  // On average.
  double height(int rod, const Stroke& stroke) const {
    const Eigen::VectorXd& lengths = lengths_[rod];
    const Eigen::VectorXd& heights = seen_.heights()[rod];
    double sum = 0;
    int count = 0;
    const double whole = lengths[lengths.size() - 1];
    for (Eigen::Index i = 0; i < heights.size(); ++i)
      if ((lengths[i] >= stroke.from && lengths[i] <= stroke.to) ||
          lengths[i] + whole <= stroke.to) {
        sum += heights[i];
        ++count;
      }
    return count > 0 ? sum / count : 0;
  }

  void draw_cable(int c) {
    if (!drawn(c)) return;
    const bool is_new = c == look_.new_cable;
    const Pen pen{is_new || !look_.plain ? accent : ink,
                  is_new ? 2.2 * look_.cable_width : look_.cable_width};
    const int curve = seen_.solid().rods + c;
    for (const Stroke& stroke : strokes_[curve]) canvas_.path(stroke.line, pen);
    for (const Eigen::Index end : {0, 1})
      canvas_.disc(lines_[curve].col(end), look_.rod_width * (is_new ? 0.75 : 0.5), pen.colour);
  }

  // A ring at the start, and an arrow a little further on.
  void draw_start(int r) {
    constexpr double to_arrow = 6;
    constexpr double length = 3.2;
    const Path& line = lines_[r];
    canvas_.disc(line.col(0), 1.3 * look_.rod_width, rod_colour(r));
    canvas_.disc(line.col(0), 0.75 * look_.rod_width, white);
    const Eigen::VectorXd& lengths = lengths_[r];
    const double end = lengths[lengths.size() - 1];
    const auto parts =
        strokes(line, seen_.solid().curves[r].closed,
                {{0, std::min(to_arrow, end / 3)}, {std::min(to_arrow + length, end / 2), end}});
    if (parts.empty()) return;
    const Vector2d tail = parts[0].line.col(0);
    const Vector2d tip = parts[0].line.rightCols(1);
    const Vector2d across = 0.45 * Vector2d(tail.y() - tip.y(), tip.x() - tail.x());
    Path head(2, 3);
    head << tip, tail + across, tail - across;
    canvas_.area(head, rod_colour(r));
    busy_.insert(busy_.end(), 6, (tail + tip) / 2);
  }

  void draw_anchors() {
    const double side = 2.2 * look_.rod_width;
    const Path anchors = on_paper(seen_.anchors(), seen_, spot_);
    for (const Vector2d at : anchors.colwise())
      canvas_.rectangle(at.x() - side / 2, at.y() - side / 2, side, side,
                        look_.plain ? plain_rod : soft_ink);
    for (const Vector2d at : anchors.colwise()) busy_.insert(busy_.end(), 4, at);
  }

  std::vector<Vector2d> busy_points() const {
    constexpr double step = 0.8;
    std::vector<Vector2d> points = busy_;
    for (std::size_t i = 0; i < strokes_.size(); ++i) {
      if (!visible(static_cast<int>(i)) || plain_cable(static_cast<int>(i))) continue;
      for (const Stroke& stroke : strokes_[i])
        for (Eigen::Index p = 0; p + 1 < stroke.line.cols(); ++p) {
          const Vector2d start = stroke.line.col(p);
          const Vector2d edge = stroke.line.col(p + 1) - start;
          const int pieces = 1 + static_cast<int>(edge.norm() / step);
          for (int k = 0; k < pieces; ++k) points.emplace_back(start + edge * k / pieces);
        }
    }
    return points;
  }

  void write(Labels& labels, const std::string& words, const Font& font,
             const std::vector<Vector2d>& anchors, Beside how) {
    constexpr double margin = 0.5;
    const Vector2d size(canvas_.width_of(words, font) + 2 * margin, font.size * 0.95);
    const auto [middle, anchor, clear] = labels.place(anchors, size, how);
    if (how == Beside::leader && !clear) {
      ++left_out_;
      return;
    }
    const Eigen::AlignedBox2d box(middle - size / 2, middle + size / 2);
    const Eigen::AlignedBox2d around(middle - 0.8 * size, middle + 0.8 * size);
    if (how == Beside::leader || !around.contains(anchor)) {
      const Vector2d end = edge_towards(box, anchor);
      canvas_.line(anchor.x(), anchor.y(), end.x(), end.y(), {font.colour, 0.1});
      if (how == Beside::leader) canvas_.disc(anchor, 0.28, font.colour);
    }
    if (how != Beside::leader)
      canvas_.rectangle(box.min().x(), box.min().y(), size.x(), size.y(), white);
    Font centred = font;
    centred.align = Align::centre;
    canvas_.text(middle.x(), middle.y() + 0.36 * font.size, words, centred);
  }

  void place_words() {
    Labels labels(spot_.bounds, busy_points());
    for (int r = 0; r < seen_.solid().rods && look_.rod_names; ++r) name_rod(labels, r);
    for (int c = 0; c < seen_.solid().cables(); ++c)
      if (numbered(c)) number_cable(labels, c);
    if (!look_.anchor_names) return;
    const Path anchors = on_paper(seen_.anchors(), seen_, spot_);
    for (int a = 0; a < anchors.cols(); ++a)
      write(labels, core::anchor_name(a), {2.5, false, soft_ink}, {anchors.col(a)}, Beside::near);
  }

  // At its start, or with a leader from anywhere on it.
  void name_rod(Labels& labels, int r) {
    const bool leader = look_.numbers == Numbers::beside;
    const Path& line = lines_[r];
    std::vector<Vector2d> anchors{line.col(0)};
    for (Eigen::Index k = 1; k < 12 && leader; ++k)
      anchors.emplace_back(line.col(k * line.cols() / 12));
    write(labels, core::rod_name(r), {look_.rod_name_size, true, rod_colour(r)}, anchors,
          leader ? Beside::leader : Beside::near);
  }

  bool numbered(int c) const {
    return look_.numbers != Numbers::none && drawn(c) && (!look_.plain || c == look_.new_cable);
  }

  void number_cable(Labels& labels, int c) {
    const Path& line = lines_[seen_.solid().rods + c];
    std::vector<Vector2d> anchors;
    for (const double t : {0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74, 0.18, 0.82})
      anchors.emplace_back((1 - t) * line.col(0) + t * line.col(1));
    write(labels, core::cable_name(c), {2.7, true, accent}, anchors,
          look_.numbers == Numbers::beside ? Beside::leader : Beside::on);
  }

  Canvas& canvas_;
  const Seen& seen_;
  const Spot& spot_;
  const Look& look_;
  std::vector<Path> lines_;
  std::vector<Eigen::VectorXd> lengths_;
  std::vector<std::vector<Stroke>> strokes_;
  std::vector<Vector2d> busy_;  // what words should not hide, beside lines
  int left_out_ = 0;
};

// The least of some round numbers times a power of ten that is not less than the value.
double round_up(double value, std::span<const double> steps) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : steps)
    if (step * power >= value * (1 - 1e-9)) return step * power;
  return 10 * power;
}

std::string short_number(double value) {
  std::string text = fabricate::tenths(value);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text;
}

}  // namespace

Seen::Seen(const Solid& solid, const Eigen::Matrix3d& axes)
    : solid_(solid),
      anchors_((axes * solid.anchors).topRows<2>()),
      crossings_(fabricate::crossings(solid.curves, axes)) {
  for (const auto& curve : solid.curves) {
    const Eigen::Matrix3Xd points = axes * curve.points;
    lines_.emplace_back(points.topRows<2>());
    heights_.emplace_back(points.row(2));
  }
  for (const Path& line : lines_)
    for (const auto& point : line.colwise()) box_.extend(Vector2d(point));
  for (const auto& point : anchors_.colwise()) box_.extend(Vector2d(point));
}

Path on_paper(const Path& points, const Seen& seen, const Spot& spot) {
  const Vector2d centre = seen.box().center();
  Path paper(2, points.cols());
  paper.row(0) = spot.middle.x() + spot.scale * (points.row(0).array() - centre.x());
  paper.row(1) = spot.middle.y() - spot.scale * (points.row(1).array() - centre.y());
  return paper;
}

int draw(Canvas& canvas, const Seen& seen, const Spot& spot, const Look& look) {
  return Sketch(canvas, seen, spot, look).draw();
}

double usual_scale(const Vector2d& size, const Vector2d& room) {
  constexpr std::array<double, 16> steps{1,   1.2, 1.4, 1.6, 1.8, 2, 2.2, 2.5,
                                         2.8, 3.2, 3.6, 4,   5,   6, 7,   8};
  const double needed = std::max(size.x() / room.x(), size.y() / room.y());
  if (needed >= 1) return 1 / round_up(needed, steps);
  return std::max(1.0, std::floor(1 / needed));  // enlarged
}

std::string scale_words(double scale) {
  return scale > 1 ? short_number(scale) + " : 1" : "1 : " + short_number(1 / scale);
}

void draw_scale_bar(Canvas& canvas, double x, double y, double scale, bool keeps_size) {
  constexpr double least = 30;  // on paper
  constexpr std::array<double, 4> steps{1, 2, 3, 5};
  const double length = round_up(least / scale, steps);
  const double left = x - length * scale;
  canvas.line(left, y, x, y, {ink, 0.3});
  for (const double end : {left, x}) canvas.line(end, y - 1, end, y + 1, {ink, 0.3});
  std::string words = short_number(length) + " mm";
  if (keeps_size) words += "  ·  scale " + scale_words(scale);
  canvas.text((left + x) / 2, y + 3.6, words, {2.6, false, soft_ink, Align::centre});
}

}  // namespace tencer::app
