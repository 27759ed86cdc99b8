#include "curves/pieces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace tencer::io {
namespace {

// A piece as a fine polygon, to measure it by.
struct Measured {
  Measured(const Piece& piece, int steps) : piece_(&piece) {
    const int n = piece.straight ? 1 : steps;
    along_.assign(n + 1, 0.0);
    Eigen::Vector3d last = piece.from();
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    for (int i = 1; i <= n; ++i) {
      const Eigen::Vector3d next = piece.at(static_cast<double>(i) / n);
      const Eigen::Vector3d edge = next - last;
      along_[i] = along_[i - 1] + edge.norm();
      if (edge.norm() > 0) {
        if (!direction.isZero(0))
          turn_ += std::atan2(direction.cross(edge).norm(), direction.dot(edge));
        direction = edge;
      }
      last = next;
    }
  }

  double length() const { return along_.back(); }
  double turn() const { return turn_; }

  Eigen::Vector3d at_length(double s) const {
    const auto after = std::clamp<std::ptrdiff_t>(
        std::ranges::upper_bound(along_, s) - along_.begin(), 1, std::ssize(along_) - 1);
    const double step = along_[after] - along_[after - 1];
    const double part = step > 0 ? (s - along_[after - 1]) / step : 0.0;
    return piece_->at((static_cast<double>(after - 1) + part) /
                      static_cast<double>(along_.size() - 1));
  }

 private:
  const Piece* piece_;
  std::vector<double> along_;  // from the start to each point
  double turn_ = 0.0;
};

// The distance of points that suits all pieces.
double spacing(std::span<const Measured> pieces) {
  constexpr double fewest = 100;
  constexpr double most = 1000;
  constexpr double turn = 0.1;
  double total = 0;
  for (const Measured& piece : pieces) total += piece.length();
  double result = total / fewest;
  for (const Measured& piece : pieces)
    if (piece.turn() > 0) result = std::min(result, turn * piece.length() / piece.turn());
  return std::max(result, total / most);
}

// The point at parameter u of the span that begins with knot `span`, by de Boor's algorithm on
// points with their weights as a fourth coordinate.
Eigen::Vector3d de_boor(const Nurbs& spline, int span, double u) {
  const int p = spline.degree;
  Eigen::Matrix4Xd d(4, p + 1);
  for (int j = 0; j <= p; ++j) {
    const int i = span - p + j;
    const double w = spline.weights.size() > 0 ? spline.weights[i] : 1.0;
    d.col(j) << w * spline.control.col(i), w;
  }
  for (int r = 1; r <= p; ++r)
    for (int j = p; j >= r; --j) {
      const double low = spline.knots[span - p + j];
      const double high = spline.knots[span + 1 + j - r];
      const double a = (u - low) / (high - low);
      d.col(j) = (1 - a) * d.col(j - 1) + a * d.col(j);
    }
  return d.col(p).head<3>() / d(3, p);
}

}  // namespace

Piece line(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return {[=](double t) -> Eigen::Vector3d { return t == 1 ? to : from + t * (to - from); }, true};
}

Piece bezier(std::vector<Eigen::Vector3d> control) {
  const bool straight = control.size() == 2;
  return {[control = std::move(control)](double t) -> Eigen::Vector3d {
            std::vector<Eigen::Vector3d> d = control;
            for (std::size_t left = d.size() - 1; left > 0; --left)
              for (std::size_t i = 0; i < left; ++i) d[i] = (1 - t) * d[i] + t * d[i + 1];
            return d[0];
          },
          straight};
}

Piece arc(const Eigen::Vector3d& center, const Eigen::Vector3d& x, const Eigen::Vector3d& y,
          double start, double sweep) {
  return {[=](double t) -> Eigen::Vector3d {
    const double angle = start + t * sweep;
    return center + std::cos(angle) * x + std::sin(angle) * y;
  }};
}

Piece reversed(Piece piece) {
  const bool straight = piece.straight;
  return {[piece = std::move(piece)](double t) { return piece.at(1 - t); }, straight};
}

const char* problem(const Nurbs& spline) {
  const auto n = spline.control.cols();
  if (spline.degree < 1 || spline.degree > 25) return "its degree is not from 1 to 25";
  if (n <= spline.degree) return "it has too few control points for its degree";
  if (std::ssize(spline.knots) != n + spline.degree + 1)
    return "its knots are not as many as its control points, its degree and one more";
  if (!std::ranges::is_sorted(spline.knots)) return "its knots decrease";
  if (spline.weights.size() > 0 && spline.weights.size() != n)
    return "its weights are not as many as its control points";
  if (spline.weights.size() > 0 && !(spline.weights.minCoeff() > 0))
    return "a weight is not positive";
  if (!(std::max(spline.from, spline.knots[spline.degree]) < std::min(spline.to, spline.knots[n])))
    return "its knots leave nothing of it";
  return nullptr;
}

std::vector<Piece> pieces(const Nurbs& spline) {
  const auto shared = std::make_shared<const Nurbs>(spline);
  const int n = static_cast<int>(spline.control.cols());
  std::vector<Piece> result;
  for (int span = spline.degree; span < n; ++span) {
    const double from = std::max(spline.from, spline.knots[span]);
    const double to = std::min(spline.to, spline.knots[span + 1]);
    if (!(from < to)) continue;
    result.push_back({[shared, span, from, to](double t) {
                        return de_boor(*shared, span, t == 1 ? to : from + t * (to - from));
                      },
                      spline.degree == 1});
  }
  return result;
}

std::vector<Eigen::Vector3d> points_along(std::span<const Piece> pieces) {
  const int steps = std::clamp(100'000 / static_cast<int>(pieces.size()), 4, 256);
  std::vector<Measured> measured;
  for (const Piece& piece : pieces) measured.emplace_back(piece, steps);
  const bool as_drawn = std::ranges::all_of(pieces, &Piece::straight);
  const double step = spacing(measured);
  std::vector<Eigen::Vector3d> points{pieces.front().from()};
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const double length = measured[i].length();
    const int parts =
        as_drawn || !(step > 0) ? 1 : std::max(1, static_cast<int>(std::lround(length / step)));
    for (int k = 1; k < parts; ++k) points.push_back(measured[i].at_length(length * k / parts));
    points.push_back(pieces[i].to());
  }
  return points;
}

}  // namespace tencer::io
