#include "fabricate/three_views.hpp"

#include <vector>

#include "drawing/axes.hpp"

namespace tencer::app {
namespace {

using Eigen::Vector2d;

constexpr double margin = 8;   // around a view, for its words
constexpr double caption = 7;  // below it

void draw_view(Book& book, const Seen& seen, double scale, const Look& look,
               const std::string& words) {
  const Vector2d size(book.width(), scale * seen.box().sizes().y() + 2 * margin);
  book.need(size.y() + caption);
  const Vector2d corner(book.left(), book.y());
  draw(book.canvas(), seen, {corner + size / 2, scale, {corner, corner + size}}, look);
  book.canvas().text(book.left(), corner.y() + size.y() + 2, words, {3, true});
  draw_scale_bar(book.canvas(), book.right(), corner.y() + size.y() + 1, scale);
  book.skip(size.y() + caption);
}

}  // namespace

void draw_three_views(Book& book, const Solid& solid, const Eigen::Matrix3d& axes, const Look& look,
                      double height, const std::array<std::string, 3>& captions) {
  constexpr double flat = 1e-3;
  std::vector<Seen> views{{solid, axes}, {solid, from_above(axes)}, {solid, from_right(axes)}};
  const Vector2d front = views[0].box().sizes();
  if (views[1].box().sizes().y() < flat * front.maxCoeff())
    while (views.size() > 1) views.pop_back();
  Vector2d largest = front;
  for (const Seen& seen : views) largest = largest.cwiseMax(seen.box().sizes());
  const Vector2d room(book.width() - 2 * margin, height - 2 * margin - caption);
  double scale = usual_scale(largest, room);
  // Two on one page, where that makes them little smaller.
  if (views.size() > 1) {
    const Vector2d two(largest.x(), front.y() + views[1].box().sizes().y());
    const double both = usual_scale(two, {room.x(), room.y() - 2 * margin - caption});
    if (both > 0.8 * scale) scale = both;
  }
  for (std::size_t i = 0; i < views.size(); ++i)
    draw_view(book, views[i], scale, look, captions[i]);
}

}  // namespace tencer::app
