// The poses in which a design rests beside its own, and the ways from one to another.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <tencer/core/error.hpp>
#include <tencer/model/design.hpp>
#include <tencer/motion/rests.hpp>
#include <vector>

namespace tencer::rehearsal {

// As motion::Rest, in the design's units.
struct DesignRest {
  model::Design design{};   // in this pose, with what is not known of it left out
  double energy = 0.0;      // of rods and loads; force times length
  double softest = 0.0;     // smallest eigenvalue, without unit
  double off_target = 0.0;  // largest distance of a vertex from the target
  double away = 0.0;        // and from the first rest
  int found = 0;
};

// As motion::Pass, in the design's units.
struct DesignPass {
  int from = 0;
  int to = 0;
  double energy = 0.0;
  std::vector<std::vector<Eigen::Matrix3Xd>> way{};  // per pose, per rod, 3 x n
  std::vector<double> energies{};                    // per pose
  int top = 0;
  double strands_apart = std::numeric_limits<double>::infinity();
  bool strands_met = false;
  std::optional<int> cable_in_rod{};

  bool free() const { return strands_apart >= 0 && !strands_met && !cable_in_rod; }
};

struct [[nodiscard]] DesignRests {
  std::vector<DesignRest> rests{};   // the first is the design's own
  std::vector<DesignPass> passes{};  // by energy
  // Per rest the passes, by index, of the lowest way to it from the first; see
  // motion::lowest_ways().
  std::vector<std::vector<int>> ways{};
  int pushes = 0;
  int lost = 0;
  int passes_missed = 0;
  bool finished = false;
};

// See motion/rests.hpp. A structure that nothing holds is moved to fit the design's own pose, along
// a way to fit the pose before. Errors: the design does not rest in its pose.
core::Expected<DesignRests> rests(const model::Design& design,
                                  const motion::RestsOptions& options = {});

}  // namespace tencer::rehearsal
