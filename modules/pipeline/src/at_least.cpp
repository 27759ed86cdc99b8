#include "at_least.hpp"

#include <tencer/lower_bound/at_least.hpp>

namespace tencer::pipeline {

model::AtLeast at_least(const Prepared& prepared, double error_percent,
                        const std::stop_token& stop) {
  const ground_structure::Problem& problem = prepared.problem;
  model::AtLeast found =
      lower_bound::at_least(problem.structure, problem.target, error_percent, stop);
  for (model::Arc& stretch : found.stretches) {
    stretch.from *= prepared.scaling.scale.length;
    stretch.to *= prepared.scaling.scale.length;
  }
  return found;
}

}  // namespace tencer::pipeline
