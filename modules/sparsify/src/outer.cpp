#include <tencer/core/error.hpp>
#include <tencer/sparsify/outer.hpp>

namespace tencer::sparsify {

void OuterOptions::validate() const {
  core::require(rounds > 0, "OuterOptions::rounds must be positive");
  core::require(iterations > 0, "OuterOptions::iterations must be positive");
  core::require(iterations_without > 0, "OuterOptions::iterations_without must be positive");
  core::require(min_gain >= 0, "OuterOptions::min_gain must not be negative");
  core::require(gradient_tolerance > 0, "OuterOptions::gradient_tolerance must be positive");
  core::require(value_tolerance >= 0, "OuterOptions::value_tolerance must not be negative");
  core::require(stability_margin >= 0 && stability_margin < 1,
                "OuterOptions::stability_margin must be in [0, 1)");
  core::require(min_eigenvalue >= 0, "OuterOptions::min_eigenvalue must not be negative");
}

}  // namespace tencer::sparsify
