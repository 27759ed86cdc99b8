// What the search went through, for the page: few snapshots, in the scene's units.
#pragma once

#include <tencer/model/scaling.hpp>
#include <tencer/model/stage_row.hpp>
#include <vector>

namespace tencer::pipeline {

// Of those that show the same one after the other keeps the first, and of what is left so many,
// evenly, with the first and the last.
void thin_snapshots(std::vector<model::StageRow>& trace, int most = 20);

void unscale_snapshots(std::vector<model::StageRow>& trace, const model::Scaling& scaling);

}  // namespace tencer::pipeline
