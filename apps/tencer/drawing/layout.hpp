// What goes where on the paper of a picture: a view or several at one scale, the bar for the scale
// and the caption.
#pragma once

#include <string>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/picture_options.hpp"

namespace tencer::app {

class Layout {
 public:
  // Keeps a reference to the solid, which has a rod and finite coordinates.
  Layout(const Solid& solid, const PictureOptions& options);

  const Eigen::Vector2d& size() const { return size_; }  // of the paper, in mm
  Look look() const;
  void draw_all(Canvas& canvas, const Look& look) const;
  // A curve of the solid on paper, in the first view.
  Path line_in_first(int curve) const;

 private:
  bool several() const { return seen_.size() > 1; }
  std::size_t columns() const { return several() ? 2 : 1; }
  double cell() const;
  void find_scale();
  Spot spot(std::size_t i, double y) const;

  bool numbers_ = true;
  std::vector<View> views_;
  std::vector<Seen> seen_;
  std::vector<double> heights_;  // of rows
  std::vector<std::string> caption_;
  Eigen::Vector2d size_ = Eigen::Vector2d::Zero();
  double scale_ = 1.0;  // the same in all views
};

}  // namespace tencer::app
