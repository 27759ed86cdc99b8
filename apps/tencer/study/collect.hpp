// The table and the pictures of a study, from what is recorded of its runs.
#pragma once

#include <filesystem>
#include <tencer/core/log.hpp>

#include "table.hpp"

namespace tencer::app::study {

// Writes study.csv and draws a picture for each scene, and with several max errors the one of
// cables over all scenes, in the study's folder; returns the rows. Runs may be made meanwhile. Who
// comes while another program collects there waits for it. `log` hears when nothing can be drawn.
core::Expected<std::vector<Row>> collect(const std::filesystem::path& folder, const core::Log& log);

}  // namespace tencer::app::study
