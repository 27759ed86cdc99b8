// What a check found out about a design, for programs: its sections with lengths and forces in the
// design's units, whether it passed, and what fails.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/model/check.hpp>
#include <tencer/model/design.hpp>

namespace tencer::io {

// A JSON object; the file of a design that has a check holds the same under "check". Its "passed"
// is null where nothing fails of what was looked at, but not everything was: "not_looked_at" has
// the names of those sections, which are not among the keys. Readers leave it alone: it holds of
// this file only.
std::string check_text(const model::Design& design, const model::Check& check);

// What the file of a design tells of its check, for those who build it.
struct FiledCheck {
  // With errors of cutting and tying up to these, 95 % of the structures are so near the pose.
  struct Tolerance {
    double length_error = 0.0;
    double attachment_error = 0.0;
    double percentile_95 = 0.0;
  };
  std::optional<bool> passed{};           // not set: nothing fails of a part of the whole check
  std::vector<std::string> fails{};       // why not, a clause each
  std::vector<model::CheckLine> lines{};  // what each section says
  std::optional<Tolerance> tolerance{};   // in the design's unit of length
};

// A design and what its file tells of its check; not set: nobody checked it.
struct CheckedDesign {
  model::Design design{};
  std::optional<FiledCheck> check{};
};

// Reads the file once. Errors: as read_design's.
core::Expected<CheckedDesign> read_checked_design(const std::filesystem::path& path);

}  // namespace tencer::io
