#include <algorithm>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/geometry/arc_length.hpp>

namespace tencer::geometry {

ArcLength::ArcLength(const Eigen::VectorXd& edge_lengths, bool closed)
    : knots_(edge_lengths.size() + 1), closed_(closed) {
  core::require(edge_lengths.size() > 0 && edge_lengths.allFinite() && edge_lengths.minCoeff() > 0,
                "ArcLength: needs positive finite edge lengths");
  knots_[0] = 0.0;
  for (int i = 0; i < edge_lengths.size(); ++i) knots_[i + 1] = knots_[i] + edge_lengths[i];
}

double ArcLength::wrap(double s) const {
  core::require(std::isfinite(s), "ArcLength::wrap: needs a finite arc length");
  if (!closed_) return std::clamp(s, 0.0, length());
  // fmod is exact; the only rounding is in the shift of a negative remainder, which can land on
  // length() itself when the remainder is tiny: that point is the seam, and so is -0.
  double r = std::fmod(s, length());
  if (r < 0.0) r += length();
  return r > 0.0 && r < length() ? r : 0.0;
}

Location ArcLength::locate(double s, Side side) const {
  const double r = wrap(s);
  const double* begin = knots_.data();
  const double* end = begin + knots_.size();
  int edge = static_cast<int>(std::upper_bound(begin, end, r) - begin) - 1;
  edge = std::min(edge, edges() - 1);
  if (side == Side::before && r == knots_[edge]) {
    if (edge > 0) return {edge - 1, 1.0};
    if (closed_) return {edges() - 1, 1.0};
  }
  return {edge, std::clamp((r - knots_[edge]) / edge_length(edge), 0.0, 1.0)};
}

}  // namespace tencer::geometry
