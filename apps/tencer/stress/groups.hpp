// The extreme cases, group by group.
#pragma once

#include <vector>

#include "row.hpp"

namespace tencer::app::stress {

// rods.cpp
Group slenderness();
Group vertex_counts();
Group uneven_edges();
Group folds();
Group units();
// cables.cpp
Group soft_and_rigid_cables();
Group cable_ratios();
Group near_attachments();
// several_rods.cpp
Group rod_ratios();
Group arrangements();
// bifurcation.cpp
Group bifurcations();
// alignment.cpp
Group alignments();

using MakeGroup = Group (*)();

// In the order of the table.
inline constexpr MakeGroup groups[] = {
    slenderness,   rod_ratios,   cable_ratios, soft_and_rigid_cables,
    vertex_counts, uneven_edges, folds,        near_attachments,
    alignments,    units,        bifurcations, arrangements};

}  // namespace tencer::app::stress
