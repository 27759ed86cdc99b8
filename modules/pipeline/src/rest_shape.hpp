// Shapes of rods at rest, taken from curves and from other rods.
#pragma once

#include <tencer/der/rod.hpp>
#include <tencer/io/scene.hpp>

namespace tencer::pipeline {

// Bends and twists `rod` at rest as `from` is at the same fractions of the length: the curvature
// per length, linear between the vertices of `from`, so that equal fractions give equal bends.
void copy_rest_shape(const der::Rod& from, der::Rod& rod);

// Bends `rod` at rest as the scene says, lengths in the scene's units; its rest lengths stay.
void set_rest_shape(const io::RestShape& shape, der::Rod& rod);

}  // namespace tencer::pipeline
