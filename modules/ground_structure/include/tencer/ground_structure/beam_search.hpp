// Networks of few candidates that nearly balance the forces at the target: where a convex problem
// spreads the forces over many cables, a few of them, chosen together, may do almost as well.
#pragma once

#include <tencer/ground_structure/problem.hpp>
#include <tencer/network/stage.hpp>
#include <tencer/network/stage_recorder.hpp>
#include <vector>

namespace tencer::ground_structure {

// Found by trying on the published models (docs/results.md): wider beams and more rounds cost time
// in proportion and change few counts.
struct BeamSearchOptions {
  int max_cables = 12;                // of a network
  int width = 60;                     // sets kept after each round
  int rounds = 6;                     // orbits of a set
  int solved = 8;                     // sets of a round that are solved for
  int max_iterations = 20;            // of Newton's method in such a solve
  double max_path_rotation = 1.0;     // see equilibrium::SolveOptions; radians
  double max_error_percent = 8;       // networks that end further from the target are dropped
  std::size_t max_candidates = 4000;  // orbits to choose from, evenly spread
  double rest_ratio = 0.99;           // of rest length to length

  // Throws std::invalid_argument, naming the field, unless all are positive.
  void validate() const;
};

// A beam search over sets of candidates, orbit by orbit of the group, by orthogonal least squares
// (Chen, Billings, Luo 1989): in each round every set of the beam takes in the orbit with which
// least is left over of the forces, measured by the displacements they cause (see
// balanced_tensions.hpp), all tensions positive. The best sets of each round are solved for, from
// the target; what is not stable there, has idle cables or ends far from the target is dropped.
// Returned is, of each number of cables, the network that ends closest; the fewest cables first.
std::vector<network::Network> beam_search(const Problem& problem, const symmetry::Group& symmetry,
                                          const BeamSearchOptions& options,
                                          const network::Control& control,
                                          network::SolveCounts& counts);

}  // namespace tencer::ground_structure
