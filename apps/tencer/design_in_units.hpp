// Designs for commands that tell lengths and energies: in units that are known.
#pragma once

#include <filesystem>
#include <tencer/core/error.hpp>
#include <tencer/model/design.hpp>

namespace tencer::app {

// Errors: as io::read_design, and units that nobody knows.
core::Expected<model::Design> read_design_in_units(const std::filesystem::path& path);

}  // namespace tencer::app
