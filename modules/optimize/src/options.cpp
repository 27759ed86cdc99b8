#include <tencer/core/error.hpp>
#include <tencer/optimize/options.hpp>

namespace tencer::optimize {

void Options::validate() const {
  core::require(max_evaluations > 0, "Options: max_evaluations must be positive");
  core::require(max_iterations > 0, "Options: max_iterations must be positive");
  core::require(gradient_tolerance > 0.0, "Options: gradient_tolerance must be positive");
  core::require(value_tolerance >= 0.0, "Options: value_tolerance must not be negative");
  core::require(initial_step > 0.0, "Options: initial_step must be positive");
}

}  // namespace tencer::optimize
