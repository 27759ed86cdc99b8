#include "curves/svg_path.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

#include "text/bad_input.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

using Eigen::Vector2d;

Eigen::Vector3d flat(const Vector2d& point) { return {point.x(), point.y(), 0.0}; }

// Reads what is written without need of blanks.
class Scanner {
 public:
  Scanner(std::string_view text, const std::string& where) : rest_(text), where_(where) {}

  // Whether anything is left after blanks and commas.
  bool more() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n\f,"), rest_.size()));
    return !rest_.empty();
  }
  char peek() const { return rest_.front(); }
  char take() {
    const char c = rest_.front();
    rest_.remove_prefix(1);
    return c;
  }
  double number() {
    if (!more()) fail(where_, "ends where a number should follow");
    std::string_view text = rest_;
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value) || std::abs(value) > largest_number)
      fail(where_, "expected a number, found " + quoted(rest_.substr(0, 12)));
    rest_ = std::string_view(end, static_cast<std::size_t>(rest_.data() + rest_.size() - end));
    return value;
  }
  // 0 or 1, which need nothing between them and what follows.
  bool flag() {
    if (!more()) fail(where_, "ends where a flag should follow");
    const char c = take();
    if (c != '0' && c != '1') fail(where_, "expected a flag 0 or 1 of an arc");
    return c == '1';
  }
  bool at_number() {
    return more() && std::string_view("+-.0123456789").find(peek()) != std::string_view::npos;
  }

 private:
  std::string_view rest_;
  const std::string& where_;
};

// The arc from one point to another of an ellipse with these half axes, turned by `turn`; made
// larger when it cannot reach (SVG 1.1, F.6).
Piece svg_arc(const Vector2d& from, const Vector2d& to, Vector2d radii, double turn, bool large,
              bool positive) {
  radii = radii.cwiseAbs();
  if (!(radii.minCoeff() > 0)) return line(flat(from), flat(to));
  const Eigen::Rotation2Dd back(-turn);
  const Vector2d half = (back * ((from - to) / 2)).cwiseQuotient(radii);  // on the unit circle
  const double too_far = half.norm();
  if (too_far > 1) radii *= too_far;
  const Vector2d d = too_far > 1 ? Vector2d(half / too_far) : half;
  // The center is off the middle of the chord by this times the chord's normal.
  const double off =
      std::sqrt(std::max(0.0, 1 / d.squaredNorm() - 1)) * (large == positive ? -1 : 1);
  const Vector2d center = off * Vector2d(d.y(), -d.x());
  const auto angle_of = [&](const Vector2d& p) {
    return std::atan2(p.y() - center.y(), p.x() - center.x());
  };
  const double start = angle_of(d);
  double sweep = angle_of(-d) - start;
  if (positive && sweep < 0) sweep += 2 * std::numbers::pi;
  if (!positive && sweep > 0) sweep -= 2 * std::numbers::pi;
  const Eigen::Rotation2Dd forth(turn);
  const Vector2d middle = forth * center.cwiseProduct(radii) + (from + to) / 2;
  return arc(flat(middle), flat(forth * Vector2d(radii.x(), 0)),
             flat(forth * Vector2d(0, radii.y())), start, sweep);
}

class PathReader {
 public:
  PathReader(std::string_view data, const std::string& where) : scan_(data, where), where_(where) {}

  std::vector<Stroke> read() {
    char command = 0;
    while (scan_.more()) {
      if (scan_.at_number()) {
        if (command == 0) fail(where_, "a path begins with M, a point to start from");
        if (command == 'Z' || command == 'z') fail(where_, "a number follows Z; expected a letter");
      } else {
        command = scan_.take();
        if (!started_ && command != 'M' && command != 'm')
          fail(where_, "a path begins with M, a point to start from");
      }
      step(command);
      // More numbers after a move are lines.
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
    }
    finish(false);
    return std::move(strokes_);
  }

 private:
  Vector2d point(bool relative) {
    const double x = scan_.number();
    const double y = scan_.number();
    return relative ? Vector2d(at_ + Vector2d(x, y)) : Vector2d(x, y);
  }

  void step(char command) {
    const bool relative = command >= 'a';
    const Vector2d mirrored_cubic = 2 * at_ - cubic_;
    const Vector2d mirrored_quadratic = 2 * at_ - quadratic_;
    switch (relative ? static_cast<char>(command - 'a' + 'A') : command) {
      case 'M':
        finish(false);
        start_ = at_ = point(relative);
        started_ = true;
        break;
      case 'L':
        line_to(point(relative));
        break;
      case 'H':
        line_to({scan_.number() + (relative ? at_.x() : 0), at_.y()});
        break;
      case 'V':
        line_to({at_.x(), scan_.number() + (relative ? at_.y() : 0)});
        break;
      case 'C': {
        const Vector2d first = point(relative);
        cubic_to(first, relative);
        return;
      }
      case 'S':
        cubic_to(mirrored_cubic, relative);
        return;
      case 'Q': {
        const Vector2d control = point(relative);
        quadratic_to(control, relative);
        return;
      }
      case 'T':
        quadratic_to(mirrored_quadratic, relative);
        return;
      case 'A':
        arc_to(relative);
        break;
      case 'Z':
        if (at_ != start_) line_to(start_);
        finish(true);
        break;
      default:
        fail(where_, "unknown command " + quoted(std::string_view(&command, 1)) +
                         "; use M L H V C S Q T A Z");
    }
    cubic_ = quadratic_ = at_;
  }

  void line_to(const Vector2d& to) {
    if (to != at_) pieces_.push_back(line(flat(at_), flat(to)));
    at_ = to;
  }
  void cubic_to(const Vector2d& first, bool relative) {
    const Vector2d second = point(relative);
    const Vector2d to = point(relative);
    pieces_.push_back(bezier({flat(at_), flat(first), flat(second), flat(to)}));
    at_ = quadratic_ = to;
    cubic_ = second;
  }
  void quadratic_to(const Vector2d& control, bool relative) {
    const Vector2d to = point(relative);
    pieces_.push_back(bezier({flat(at_), flat(control), flat(to)}));
    at_ = cubic_ = to;
    quadratic_ = control;
  }
  void arc_to(bool relative) {
    const double x = scan_.number();
    const double y = scan_.number();
    const double turn = scan_.number() / 180 * std::numbers::pi;
    const bool large = scan_.flag();
    const bool positive = scan_.flag();
    const Vector2d to = point(relative);
    if (to != at_) pieces_.push_back(svg_arc(at_, to, {x, y}, turn, large, positive));
    at_ = to;
  }

  void finish(bool closed) {
    if (!pieces_.empty()) strokes_.push_back({std::move(pieces_), closed, where_});
    pieces_.clear();
    at_ = start_;
  }

  Scanner scan_;
  const std::string& where_;
  std::vector<Stroke> strokes_;
  std::vector<Piece> pieces_;
  bool started_ = false;
  Vector2d start_ = Vector2d::Zero();
  Vector2d at_ = Vector2d::Zero();
  Vector2d cubic_ = Vector2d::Zero();      // the last control point, for S
  Vector2d quadratic_ = Vector2d::Zero();  // for T
};

}  // namespace

std::vector<double> svg_numbers(std::string_view text, const std::string& where) {
  Scanner scan(text, where);
  std::vector<double> numbers;
  while (scan.more()) numbers.push_back(scan.number());
  return numbers;
}

std::vector<Stroke> svg_strokes(std::string_view data, const std::string& where) {
  return PathReader(data, where).read();
}

}  // namespace tencer::io
