// What a scene needs and what it does not, told from what was prepared for it.
#pragma once

#include <tencer/pipeline/prepare.hpp>
#include <vector>

namespace tencer::pipeline {

// Reads all of `prepared` but its parts.
std::vector<Part> parts_of(const io::Scene& scene, const Prepared& prepared);

}  // namespace tencer::pipeline
