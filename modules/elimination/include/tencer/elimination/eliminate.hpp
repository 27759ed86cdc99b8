// Fewer cables by number: out of a network that holds the target, one cable after another, all
// others refitted (the paper's open problem of asking for a number of cables, section 6.3).
#pragma once

#include <tencer/elimination/options.hpp>
#include <tencer/elimination/solution.hpp>
#include <tencer/ground_structure/problem.hpp>

namespace tencer::elimination {

// Several backward eliminations, each with another balance between closeness and stability, are
// made side by side. In each, the cable goes whose loss is predicted to cost least once the others
// have been refitted, gradually where it cannot go at once; attachments slide, cables stay as good
// as inextensible. The best networks are fitted closely, then varied: one of the problem's
// candidates goes in where it helps most, and others out.
//
// network: of problem.structure with its cables; with a symmetry in the problem it must have it
// too. One that is not in stable equilibrium with every cable pulling comes back as it is, with its
// fault. Throws std::invalid_argument for wrong options or rules.
EliminationResult eliminate(const network::Network& network,
                            const ground_structure::Problem& problem,
                            const EliminationOptions& options = {},
                            const network::Control& control = {});

}  // namespace tencer::elimination
