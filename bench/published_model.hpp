// Reads one published model (a JSON file of rods, cables, target and equilibrium) for comparison.
#pragma once

#include <string>
#include <tencer/model/structure.hpp>
#include <vector>

namespace bench {

struct PublishedModel {
  std::string name;
  tencer::model::Structure structure;
  std::vector<Eigen::Matrix3Xd> target;     // per rod, 3 x n
  std::vector<Eigen::Matrix3Xd> published;  // the stored equilibrium
  int cables = 0;
  double max_error_percent = 0.0;
  bool rigidly_aligned = true;
};

PublishedModel read_published_model(const std::string& path);

// Every model of a folder, in the order of their names.
std::vector<PublishedModel> read_published_models(const std::string& folder);

}  // namespace bench
