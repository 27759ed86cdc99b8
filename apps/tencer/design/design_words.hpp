// What `tencer design` says.
#pragma once

#include <filesystem>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/model/design.hpp>
#include <tencer/model/feasibility.hpp>
#include <tencer/model/scene.hpp>

#include "command.hpp"

namespace tencer::app {

// Says what was understood of the input: what is to be built, and the scene's notes, which are
// said then.
void introduce(model::Scene& scene, const Console& console);

// Says what the scene needs and what is left out, and where the result would go. Errors: as
// pipeline::prepare().
core::Expected<ExitCode> dry_run(const model::Scene& scene, const std::filesystem::path& folder,
                                 const Console& console);

// The design, and why it is not what was asked for, if it is not.
std::string result_in_words(const model::Design& design, const model::Feasibility& feasible);

// Where to look, and how long it took.
std::string seen_in(const std::filesystem::path& folder, double seconds);

}  // namespace tencer::app
