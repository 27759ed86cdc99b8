// A structure from three sides, at one scale.
#pragma once

#include <array>

#include "drawing/drawing.hpp"
#include "fabricate/book.hpp"

namespace tencer::app {

// Below each other: the front, from above, and from the right, over as many pages as they take,
// each no higher than `height`. axes: of the front, see Seen. A flat structure has a front only.
void draw_three_views(Book& book, const Solid& solid, const Eigen::Matrix3d& axes, const Look& look,
                      double height, const std::array<std::string, 3>& captions);

}  // namespace tencer::app
