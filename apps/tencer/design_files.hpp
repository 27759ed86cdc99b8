// The files of a design in its folder, and what is said of it on the terminal.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/io/design.hpp>

namespace tencer::app {

// design.json, trace.csv, pose.obj, view.html and picture.svg in `folder`, which is made when it is
// not there: all of them or, on an Error, none.
std::optional<core::Error> write_design_files(const std::filesystem::path& folder,
                                              const io::Design& design);

// A few lines: cables, error, certificate.
std::string summary(const io::Design& design);

}  // namespace tencer::app
