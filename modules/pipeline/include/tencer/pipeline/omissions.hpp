// What a scene needs and what it does not, and is therefore left out.
#pragma once

#include <string>
#include <tencer/pipeline/prepare.hpp>
#include <vector>

namespace tencer::pipeline {

// Something that only some scenes need, and whether this one does.
struct Feature {
  std::string name{};  // "theta", "z", "registration", ...
  bool used = false;   // false: left out
  std::string why{};   // of either, half a sentence
};

std::vector<Feature> features_of(const model::Scene& scene, const Prepared& prepared);

}  // namespace tencer::pipeline
