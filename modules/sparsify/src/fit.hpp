// The last touch to a network: as close to its target as it goes without losing stability.
#pragma once

#include <tencer/sparsify/thin.hpp>

#include "walker.hpp"

namespace tencer::sparsify {

double diagonal_of(const sensitivity::Target& target);  // of its bounding box

// Fits what the walker is at, which must be usable, and leaves it there. softness: see Drive.
void fit(Walker& walker, const sensitivity::Target& target, Measure measure, double softness);

}  // namespace tencer::sparsify
