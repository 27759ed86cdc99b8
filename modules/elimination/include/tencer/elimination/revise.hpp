// From a network that there is to one with fewer cables, with more, or for a target that has moved:
// in a fraction of the time of a search.
#pragma once

#include <tencer/elimination/options.hpp>
#include <tencer/elimination/solution.hpp>
#include <tencer/ground_structure/problem.hpp>

namespace tencer::elimination {

struct Revision {
  // Of as many rods as the problem's, with any number of vertices each, in or near equilibrium.
  network::Network network{};
  int kept = 0;   // so many of its first cables stay as they are
  int going = 0;  // so many after these are taken out, others taking over
};

// Fits the network to the target, takes out the cables that the goal can do without, puts others
// in where that helps, one a round, as in the local search of search(). The result's network has a
// fault when the network is in no stable equilibrium with the problem's rods. Throws
// std::invalid_argument for wrong options or rules.
EliminationResult revise(const Revision& revision, const ground_structure::Problem& problem,
                         const EliminationOptions& options = {},
                         const network::Control& control = {});

}  // namespace tencer::elimination
