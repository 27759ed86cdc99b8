// The networks that a search begins with.
#pragma once

#include <span>
#include <tencer/ground_structure/problem.hpp>
#include <tencer/network/stage_recorder.hpp>
#include <vector>

#include "multistart/multistart.hpp"

namespace tencer::elimination {

struct Starts {
  std::vector<Start> near{};  // of many rods: cables between neighbours only
  std::vector<Start> full{};  // the forces balanced by any cables; failing these, springs
  std::vector<Start> few{};   // of few orbits of the symmetries that the target nearly has
  bool many_rods = false;
  network::SolveCounts counts{};  // of `few`, which has no row of its own

  bool empty() const { return full.empty() && few.empty(); }
  const network::Network& first() const { return (full.empty() ? few : full).front().network; }

  std::vector<symmetry::Group> symmetries{};  // to which `few` refers
};

// Rows of what was done, and the first network of a balance that holds (failing all, the first),
// go to `result`.
Starts starts_of(const ground_structure::Problem& problem, const EliminationOptions& options,
                 const network::Control& control, network::StageResult& result);

}  // namespace tencer::elimination
