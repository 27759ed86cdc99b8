// How the cables of a design are pulled and let go, step after step.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <tencer/model/design.hpp>
#include <vector>

namespace tencer::model {

// What becomes of a cable's length in a step.
struct LengthChange {
  bool by = false;  // so much more (less, below zero) than before; false: to so much
  double amount = 0.0;
  std::string unit = "%";  // of the cable's length in the design, or one of length_units()

  // The length after the step, from that before and that in the design, all in length_unit (one of
  // length_units() unless this is in %).
  double apply(double before, double in_design, std::string_view length_unit) const;
};

// "by -12 mm", "by -10 %", "to 80 mm", "to 100 %". Not set: it is none of these.
std::optional<LengthChange> read_length_change(std::string_view text);

struct ScheduleStep {
  // Per cable of the design; not set: it stays as it is.
  std::vector<std::optional<LengthChange>> changes{};
  int frames = 10;  // poses on the way
};

struct Schedule {
  std::vector<ScheduleStep> steps{};
};

// The cables' lengths after each step, in the design's unit. Those of a schedule that leave a cable
// no length are not positive. Throws std::invalid_argument unless steps have an entry a cable.
std::vector<Eigen::VectorXd> lengths_of(const Schedule& schedule, const Design& design);

}  // namespace tencer::model
