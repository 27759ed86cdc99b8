// The viewer page: a design in 3D with its cut list, as one HTML file that needs no network.
#pragma once

#include <string>
#include <tencer/io/design.hpp>

namespace tencer::app {

// Holds the whole design file, from which scripts make the view and the tables, and the picture of
// picture.hpp for where there is no WebGL. Requires at least one rod and finite coordinates.
std::string view_page(const model::Design& design);

}  // namespace tencer::app
