// Where the words of a drawing go so that none hides another.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "fabricate/canvas.hpp"

namespace tencer::app {

// What a drawing holds already, and the words put into it.
class Labels {
 public:
  // bounds: where words may be. busy: points of the drawing's lines, which words should not hide.
  Labels(const Eigen::AlignedBox2d& bounds, std::vector<Eigen::Vector2d> busy);

  // A place for the middle of words of this size beside one of `anchors`, the first being best:
  // on it, when `on` says so, else beside it; away from words placed before, and from busy points
  // as far as can be.
  Eigen::Vector2d place(const std::vector<Eigen::Vector2d>& anchors, const Eigen::Vector2d& size,
                        bool on);

 private:
  double cost(const Eigen::AlignedBox2d& box) const;

  Eigen::AlignedBox2d bounds_;
  std::vector<Eigen::Vector2d> busy_;  // from left to right
  std::vector<Eigen::AlignedBox2d> placed_;
};

}  // namespace tencer::app
