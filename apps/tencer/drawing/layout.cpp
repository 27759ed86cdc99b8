#include "drawing/layout.hpp"

#include <algorithm>
#include <sstream>
#include <tencer/core/error.hpp>
#include <tencer/core/words.hpp>
#include <utility>

#include "drawing/axes.hpp"

namespace tencer::app {
namespace {

using Eigen::Vector2d;

constexpr double width = 170;       // of what holds several views, in mm
constexpr double margin = 4;        // around everything
constexpr double words_around = 5;  // of a view
constexpr double tallest = 180;     // of a view
constexpr double below_view = 6;    // its name
constexpr double scale_bar = 9;     // and its length below it
constexpr double narrowest = 80;
constexpr Font caption_font{3.2};
constexpr double caption_line = 1.4 * caption_font.size;

Eigen::Matrix3d axes_of(View view, const Solid& solid) {
  const Eigen::Matrix3d front =
      solid.views.empty() ? principal_axes(points_of(solid)) : axes_along(solid.views);
  if (view == View::top) return from_above(front);
  if (view == View::side) return from_right(front);
  return view == View::front ? front : oblique(front);
}

bool is_flat(const Eigen::Matrix3Xd& points) {
  constexpr double flat = 1e-3;
  const Eigen::Matrix3Xd seen = principal_axes(points) * points;
  const Eigen::Vector3d sizes = seen.rowwise().maxCoeff() - seen.rowwise().minCoeff();
  return sizes.z() < flat * sizes.maxCoeff();
}

std::vector<std::string> lines_of(const std::string& words, double room) {
  std::vector<std::string> lines;
  // Letters are as wide on every canvas.
  svg_drawing(1, 1, "", [&](Canvas& canvas) {
    std::istringstream stream(words);
    for (std::string word; stream >> word;) {
      const std::string longer = lines.empty() ? word : lines.back() + ' ' + word;
      if (lines.empty() || canvas.width_of(longer, caption_font) > room)
        lines.push_back(word);
      else
        lines.back() = longer;
    }
  });
  return lines;
}

}  // namespace

Layout::Layout(const Solid& solid, const PictureOptions& options) : numbers_(options.numbers) {
  const Eigen::Matrix3Xd points = points_of(solid);
  views_ = options.views;
  const bool from_front = !solid.views.empty() || is_flat(points);
  if (views_.empty()) views_ = {from_front ? View::front : View::oblique};
  for (const View view : views_) seen_.emplace_back(solid, axes_of(view, solid));
  find_scale();
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const std::size_t row = i / columns();
    heights_.resize(row + 1, 0.0);
    heights_[row] = std::max(heights_[row], scale_ * seen_[i].box().sizes().y() + 2 * words_around +
                                                (several() ? below_view : 0));
  }
  size_.x() = width;
  if (!several())
    size_.x() =
        std::max(narrowest, scale_ * seen_[0].box().sizes().x() + 2 * (margin + words_around));
  caption_ = lines_of(options.caption, size_.x() - 2 * margin);
  size_.y() = 2 * margin + scale_bar + caption_line * static_cast<double>(caption_.size());
  for (const double height : heights_) size_.y() += height;
}

Look Layout::look() const {
  const bool only_rod = seen_.front().solid().rods == 1;
  return {.rod_width = several() ? 1.0 : 1.5,
          .cable_width = several() ? 0.25 : 0.32,
          .starts = false,
          .rod_names = !only_rod && numbers_,
          .rod_name_size = several() ? 3.4 : 4.6,
          .anchor_names = false,
          .numbers = numbers_ ? Numbers::beside : Numbers::none};
}

void Layout::draw_all(Canvas& canvas, const Look& look) const {
  canvas.rectangle(0, 0, size_.x(), size_.y(), white);
  double y = margin;
  int left_out = 0;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const Spot where = spot(i, y);
    left_out += draw(canvas, seen_[i], where, look);
    if (several())
      canvas.text(where.middle.x(), y + heights_[i / columns()] - 2, name_of(views_[i]),
                  {3, false, soft_ink, Align::centre});
    if (i % columns() + 1 == columns() || i + 1 == seen_.size()) y += heights_[i / columns()];
  }
  draw_scale_bar(canvas, size_.x() - margin, y + 3, scale_, false);
  if (left_out > 0)
    canvas.text(margin, y + 6.6, "no room for " + core::counted(left_out, "name"),
                {2.6, false, soft_ink});
  y += scale_bar;
  for (const std::string& line : caption_) {
    canvas.text(margin, y + caption_font.size, line, caption_font);
    y += caption_line;
  }
}

Path Layout::line_in_first(int curve) const {
  return on_paper(seen_.front().lines()[curve], seen_.front(), spot(0, margin));
}

double Layout::cell() const { return (width - 2 * margin) / static_cast<double>(columns()); }

void Layout::find_scale() {
  Vector2d largest = Vector2d::Zero();
  for (const Seen& seen : seen_) largest = largest.cwiseMax(seen.box().sizes());
  core::require(largest.allFinite() && largest.maxCoeff() > 0,
                "picture: needs a rod with finite coordinates and some extent");
  const double room = cell() - 2 * words_around;
  scale_ = std::min(room / std::max(largest.x(), 1e-9 * largest.y()),
                    (several() ? room : tallest) / std::max(largest.y(), 1e-9 * largest.x()));
}

Spot Layout::spot(std::size_t i, double y) const {
  const double wide = several() ? cell() : size_.x() - 2 * margin;
  const double high = heights_[i / columns()] - (several() ? below_view : 0);
  const Vector2d corner(margin + wide * static_cast<double>(i % columns()), y);
  const Vector2d sizes(wide, high);
  return {corner + sizes / 2, scale_, {corner, corner + sizes}};
}

}  // namespace tencer::app
