// In which order the sheet has cables tied.
#pragma once

#include <tencer/fabricate/cut_list.hpp>
#include <tencer/model/design.hpp>
#include <vector>

namespace tencer::app {

// A cable tied to what stands by itself.
struct TyingStep {
  int cable = 0;
  double moved_mm = 0.0;   // largest distance of a vertex by tying it
  double tension_n = 0.0;  // that it is tied with
  int parts = 1;           // groups of rods that nothing ties together before
};

struct TyingOrder {
  bool rehearsed = false;   // false: the design does not rest in its pose, and nothing is known
  std::vector<int> held{};  // first, while the rods are held in shape
  std::vector<int> would_fall{};  // of these, those that the structure falls without
  std::vector<TyingStep> steps{};

  std::vector<int> cables() const;  // all, one after the other
};

// Found by taking the design apart (motion/tying.hpp); those that are tied first, and all where
// nothing is known, as hands work their way along the rods (fabricate/tying_order.hpp).
TyingOrder tying_order(const model::Design& design, const fabricate::CutList& list);

}  // namespace tencer::app
