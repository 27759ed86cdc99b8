// The viewer page: designs in 3D with their cut lists and plots, as one HTML file that needs no
// network.
#pragma once

#include <span>
#include <string>

#include "view/page_data.hpp"

namespace tencer::app {

// Holds the whole files of the designs (view/page_data.hpp), from which scripts make the view and
// the tables, and the picture of the first, drawing/picture.hpp's, for where there is no WebGL. It
// opens with design number `first`. Requires at least one design, and of each a rod and finite
// coordinates.
std::string view_page(std::span<const PageDesign> designs, std::size_t first = 0);

// Of one design.
std::string view_page(const model::Design& design);

}  // namespace tencer::app
