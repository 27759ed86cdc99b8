// What the runs of a study look like.
#pragma once

#include "plot.hpp"
#include "table.hpp"

namespace tencer::app::study {

// Error against run time of a scene's runs with numbers of cables, a curve for each method and
// optimizer: through the ends of the stages, from the designs in the study's folder; or, with
// several resolutions or max errors, through the designs, from the table. The scene's file is
// asked for the allowed error, if it is there.
Plot plot_of(const std::string& scene, std::span<const Row> rows,
             const std::filesystem::path& folder);

// Cables against the max error asked for, over all scenes: how many nine in ten, half and one in
// ten of them make do with, for each method and optimizer. A run without a complete design counts
// as one that no number of cables is enough for. No curves with fewer than two max errors.
CountPlot cables_plot(std::span<const Row> rows);

}  // namespace tencer::app::study
