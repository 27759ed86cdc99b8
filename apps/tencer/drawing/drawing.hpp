// A structure drawn from one side: rods with gaps where others pass over them, cables with numbers,
// where each rod starts and which way it goes. The one home of drawing on paper: sheets and
// pictures use it.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <tencer/fabricate/crossings.hpp>
#include <vector>

#include "drawing/solid.hpp"
#include "drawing/strokes.hpp"

namespace tencer::app {

// From far away. axes: rows are right, up, towards the eye.
class Seen {
 public:
  Seen(const Solid& solid, const Eigen::Matrix3d& axes);

  // What is drawn fits in: mm, y up.
  const Eigen::AlignedBox2d& box() const { return box_; }
  const Solid& solid() const { return solid_; }
  const std::vector<Path>& lines() const { return lines_; }  // one a curve of the solid
  const std::vector<Eigen::VectorXd>& heights() const { return heights_; }  // of their points
  const Path& anchors() const { return anchors_; }
  const std::vector<fabricate::Crossing>& crossings() const { return crossings_; }

 private:
  const Solid& solid_;
  std::vector<Path> lines_;
  std::vector<Eigen::VectorXd> heights_;
  Path anchors_;
  std::vector<fabricate::Crossing> crossings_;
  Eigen::AlignedBox2d box_;
};

// Where a drawing goes: the middle of its box, and mm on paper a mm of the structure.
struct Spot {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double scale = 1.0;
  Eigen::AlignedBox2d bounds{};  // of words
};

enum class Numbers { on_cables, beside, none };

struct Look {
  double rod_width = 1.0;
  double cable_width = 0.28;
  bool starts = true;  // where rods start, and which way they go
  bool rod_names = true;
  double rod_name_size = 4.6;
  bool anchor_names = true;
  Numbers numbers = Numbers::on_cables;  // beside: at the ends of leaders, as are rods' names
  bool plain = false;                    // rods in grey, cables but `new_cable` in ink
  std::vector<bool> tied{};              // the cables that are drawn and numbered; none: all
  int new_cable = -1;                    // drawn to be seen, and numbered
};

// Points seen along the axes, on paper.
Path on_paper(const Path& points, const Seen& seen, const Spot& spot);

// Returns how many names are left out, since they would hide others: only where they are at the
// ends of leaders.
int draw(Canvas& canvas, const Seen& seen, const Spot& spot, const Look& look);

// 1 : n, or n : 1, for the least n of those that people use at which `size` fits into `room`.
double usual_scale(const Eigen::Vector2d& size, const Eigen::Vector2d& room);
std::string scale_words(double scale);  // "1 : 2.5"

// A bar of some round length, its right end at x, with that length below, and the scale, where the
// paper keeps its size.
void draw_scale_bar(Canvas& canvas, double x, double y, double scale, bool keeps_size = true);

}  // namespace tencer::app
