#include "design/design_progress.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tencer/core/words.hpp>
#include <tencer/model/target.hpp>
#include <tencer/model/units.hpp>
#include <tencer/pipeline/design.hpp>

namespace tencer::app {
namespace {

std::optional<double> diagonal_in_mm(const model::Scene& scene) {
  if (std::ranges::count(model::length_units(), scene.length_unit) == 0) return std::nullopt;
  return 1000 * model::metres(scene.length_unit) * model::diagonal(scene.target);
}

// Forces that balance at the target itself do not tell where the network will rest.
bool is_solved(const model::Score& score) {
  constexpr double at_target = 1e-6;  // %
  return std::isfinite(score.max_percent) && score.max_percent > at_target;
}

}  // namespace

DesignProgress::DesignProgress(Activity& activity, const model::Scene& scene, bool every_number)
    : activity_(activity),
      goal_(pipeline::goal_of(scene.design)),
      diagonal_mm_(diagonal_in_mm(scene)) {
  goal_.every_number = every_number;
}

// "4.02 mm", or in % of the target's size.
std::string DesignProgress::distance(double percent) const {
  std::ostringstream text;
  text.precision(3);
  if (diagonal_mm_)
    text << percent / 100 * *diagonal_mm_ << " mm";
  else
    text << percent << " %";
  return text.str();
}

void DesignProgress::tell(const network::Progress& progress) {
  std::string words(progress.stage);
  if (progress.cables > 0) {
    words += ": " + core::counted(progress.cables, "cable");
    const model::Score now{.cables = progress.cables, .max_percent = progress.max_percent};
    if (is_solved(now)) {
      words += ", " + distance(now.max_percent);
      const bool better = !best_ || (goal_.met(now) && !goal_.met(*best_)) ||
                          (goal_.met(now) == goal_.met(*best_) && goal_.improves(now, *best_));
      if (better) best_ = now;
    }
  }
  if (best_ && !goal_.every_number && goal_.met(*best_))
    words += "; best so far " + core::counted(best_->cables, "cable") + ", " +
             distance(best_->max_percent);
  activity_.now(words);
}

}  // namespace tencer::app
