// Checks and defaults of a scene's targets, whether they come from a scene or from a bare curve.
#pragma once

#include <string>
#include <tencer/io/scene.hpp>
#include <vector>

namespace tencer::io {

// Fails when two vertices coincide, so that a cable between them would have no length; `where` for
// the error's place.
void check_vertices(const std::vector<SceneRod>& rods, const std::string& where);

// Fails when a planar scene has different z coordinates.
void check_plane(const Scene& scene, const std::string& where);

// 1/1000 of the longest rod: all rods are of the same stock unless the scene says otherwise.
double default_radius(const std::vector<SceneRod>& rods);

}  // namespace tencer::io
