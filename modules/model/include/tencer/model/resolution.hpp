// The same scene with more or fewer vertices, to see what their number does to designs and run
// time.
#pragma once

#include <tencer/model/scene.hpp>
#include <vector>

namespace tencer::model {

// Every rod with `times` as many edges (a closed rod at least 3, an open one at least 2), evenly
// along the cubic spline through the scene's vertices. What the scene says by vertex goes to the
// nearest of the new ones, and an edge pinned at both ends is pinned all along; what it says by arc
// length keeps its share of the rod's length. Throws std::invalid_argument unless times > 0.
Scene at_resolution(const Scene& scene, double times);
// The same with a factor for each rod.
Scene at_resolution(const Scene& scene, const std::vector<double>& times);

// Rods that have more than twice as many vertices as their bends need, which is 1000 or one for
// every 0.03 radians, with as many as that, and a note of it.
Scene with_enough_vertices(const Scene& scene);

}  // namespace tencer::model
