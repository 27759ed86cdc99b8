// The forward solver against closed forms of the continuum: what the number of vertices costs and
// gains.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace tencer::app::study {

struct Accuracy {
  std::string problem{};
  int edges = 0;
  double seconds = 0.0;  // median of several times
  double error = 0.0;    // of the answer, relative
};

// All problems with each number of edges, from a start that is not the answer. `progress` gets each
// as it is measured; may be empty.
std::vector<Accuracy> closed_form_errors(std::span<const int> edges,
                                         const std::function<void(const Accuracy&)>& progress);

// CSV: problem,edges,seconds,relative_error.
std::string accuracy_text(std::span<const Accuracy> rows);

}  // namespace tencer::app::study
