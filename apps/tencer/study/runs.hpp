// The runs of a study: which there are, and how one is made.
#pragma once

#include <optional>
#include <stop_token>

#include "plot.hpp"
#include "table.hpp"

namespace tencer::app::study {

struct Choice {
  std::vector<std::filesystem::path> scenes{};
  std::vector<std::string> methods{};
  std::vector<std::string> force_balance{};  // optimizers of this method
  std::vector<std::string> dense_springs{};  // and of this one
  std::vector<double> resolutions{};
};

// Scene after scene, methods, optimizers, resolutions. Error: two scenes of the same name.
core::Expected<std::vector<Run>> runs_of(const Choice& choice);

// The run as a process of its own (`tencer design`), so that whatever becomes of it - a crash, no
// memory left, no end - costs one row. Its design is in folder/runs, beside a log of what it
// printed. limit: seconds until it has to end with the best design so far; 0: none. None when it
// was stopped.
std::optional<Row> make(const Run& run, const std::filesystem::path& folder, double limit,
                        const std::stop_token& stop);

// Error against run time of a scene's runs with numbers of cables, a curve for each method and
// optimizer: through the ends of the stages, from the designs in folder/runs; or, with several
// resolutions, through the designs, from the table.
Plot plot_of(const std::string& scene, std::span<const Row> rows,
             const std::filesystem::path& folder);

}  // namespace tencer::app::study
