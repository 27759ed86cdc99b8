// Published models with the figures they were published with, for comparison.
#pragma once

#include <string>
#include <tencer/model/design.hpp>
#include <vector>

namespace bench {

struct PublishedModel {
  tencer::model::Design design;  // its pose is the stored equilibrium
  double max_error_percent = 0.0;

  int cables() const { return static_cast<int>(design.structure.cables.size()); }
};

// Every model of a folder, in the order of their names. Throws std::runtime_error.
std::vector<PublishedModel> read_published_models(const std::string& folder);

}  // namespace bench
