// The files of a design in its folder, and what is said of it on the terminal.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/io/design.hpp>
#include <tencer/model/feasibility.hpp>

namespace tencer::app {

// Why the result of what has this name cannot go into `folder`, known before the work is done: it
// cannot be written, or it holds the design of something else, which is kept unless `force`.
std::optional<core::Error> result_problem(const std::filesystem::path& folder,
                                          const std::string& name, bool force);

// design.json, trace.csv, pose.obj, report.txt, view.html and picture.svg in `folder`, which is
// made when it is not there: all of them or, on an Error, none. Of an earlier result nothing is
// left in the folder; files that no result has stay.
std::optional<core::Error> write_design_files(const std::filesystem::path& folder,
                                              const model::Design& design);

// That the folder holds a sheet (tencer fabricate), which a design written just now cannot be of,
// and how to make it anew; not set: it does not.
std::optional<std::string> old_sheet(const std::filesystem::path& folder);

// Pictures of the design, each of the format of its ending (drawing/picture.hpp), which is one of
// those that there are.
std::optional<core::Error> write_pictures(std::span<const std::filesystem::path> pictures,
                                          const model::Design& design);

// In `folder` the files of the design asked for, with all designs in view.html, and trade-off.csv,
// one line a design; and in a folder cables-N for each number N of cables the files of that design.
// The folders of designs come first, each all or nothing; on an Error those that are new are
// removed again. Likewise nothing is left of an earlier result.
std::optional<core::Error> write_trade_off(const std::filesystem::path& folder,
                                           std::span<const model::Design> designs,
                                           const model::Design& asked);

// Whether a design is in the folder.
bool holds_design(const std::filesystem::path& folder);

// trade-off.csv for the terminal; nothing when there are no designs.
std::string trade_off_table(std::span<const model::Design> designs);

// feasible.json and picture.svg into `folder`, likewise.
std::optional<core::Error> write_feasibility_files(const std::filesystem::path& folder,
                                                   const model::Feasibility& feasibility);

}  // namespace tencer::app
