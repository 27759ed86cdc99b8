// Where the words of a drawing go so that none hides another.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "drawing/canvas.hpp"

namespace tencer::app {

// How words belong to their place.
enum class Beside {
  on,      // on it, else near it
  near,    // near it
  leader,  // some way off, joined to it by a line of its own
};

// Words' middle, the one of their anchors that they belong to, and whether they are clear of
// others.
struct Placed {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  Eigen::Vector2d anchor = Eigen::Vector2d::Zero();
  bool clear = true;
};

// What a drawing holds already, and the words put into it.
class Labels {
 public:
  // bounds: where words may be. busy: points of the drawing's lines, which words should not hide.
  Labels(const Eigen::AlignedBox2d& bounds, std::vector<Eigen::Vector2d> busy);

  // A place for words of this size beside one of `anchors`, the first being best: away from words
  // placed before and from their leaders, and from busy points as far as can be. Words with a
  // leader that are not clear of others are not to be drawn, and no words placed later heed them.
  Placed place(const std::vector<Eigen::Vector2d>& anchors, const Eigen::Vector2d& size,
               Beside how);

 private:
  double cost(const Eigen::AlignedBox2d& box) const;
  double cost_of_leader(const Eigen::Vector2d& anchor, const Eigen::AlignedBox2d& box) const;

  Eigen::AlignedBox2d bounds_;
  std::vector<Eigen::Vector2d> busy_;  // from left to right
  std::vector<Eigen::AlignedBox2d> placed_;
  std::vector<Placed> leaders_;
};

// Where the line from an anchor to the middle of a box meets it.
Eigen::Vector2d edge_towards(const Eigen::AlignedBox2d& box, const Eigen::Vector2d& anchor);

}  // namespace tencer::app
