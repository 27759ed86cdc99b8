// The same scene with more or fewer vertices, to see what their number does to designs and run
// time.
#pragma once

#include <tencer/io/scene.hpp>

namespace tencer::pipeline {

// Every rod with `times` as many edges (a closed rod at least 3, an open one at least 2), evenly
// along the cubic spline through the scene's vertices. What the scene says by vertex goes to the
// nearest of the new ones, and an edge pinned at both ends is pinned all along; what it says by arc
// length keeps its share of the rod's length. Requires times > 0.
io::Scene at_resolution(const io::Scene& scene, double times);

}  // namespace tencer::pipeline
