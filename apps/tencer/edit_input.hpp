// What the command line says of a design to go on from.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <tencer/core/error.hpp>
#include <tencer/model/scene.hpp>
#include <vector>

namespace tencer::app {

struct EditRequest {
  std::filesystem::path from;  // another design; empty: none
  std::vector<int> keep;
  std::vector<int> forbid;
  std::optional<int> add;
  std::optional<int> remove;
};

void add_edit(CLI::App& command, EditRequest& request);

// Reads the design, and puts what is given in place of the scene's edit. A number of cables more or
// fewer comes before the scene's own, unless `cables_given` on the command line.
std::optional<core::Error> apply(const EditRequest& request, bool cables_given,
                                 model::Scene& scene);

}  // namespace tencer::app
