// A design that is being searched for, in the words of one line.
#pragma once

#include <optional>
#include <tencer/model/goal.hpp>
#include <tencer/model/scene.hpp>
#include <tencer/network/stage.hpp>

#include "terminal/activity.hpp"

namespace tencer::app {

// Tells the activity what the search does now and the best network so far: the fewest cables within
// the error asked for, or the closest.
class DesignProgress {
 public:
  DesignProgress(Activity& activity, const model::Scene& scene, bool every_number);

  void tell(const network::Progress& progress);

 private:
  std::string distance(double percent) const;

  Activity& activity_;
  model::Goal goal_;
  std::optional<double> diagonal_mm_;  // of the target; not set: its unit is not known
  std::optional<model::Score> best_;
};

}  // namespace tencer::app
