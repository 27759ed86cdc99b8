// The runs of a study: which there are, and how one is made.
#pragma once

#include <optional>
#include <stop_token>

#include "table.hpp"

namespace tencer::app::study {

struct Choice {
  std::vector<std::filesystem::path> scenes{};
  std::vector<std::string> methods{};
  std::vector<std::string> force_balance{};  // optimizers of this method
  std::vector<std::string> dense_springs{};  // and of this one
  std::vector<double> resolutions{};
  std::vector<double> max_errors{};  // %; empty: the scenes' own
};

// Scene after scene, methods, optimizers, resolutions, max errors. Error: two scenes of the same
// name.
core::Expected<std::vector<Run>> runs_of(const Choice& choice);

struct MakeOptions {
  double limit = 0.0;            // seconds until a run ends with the best design so far; 0: none
  std::optional<int> threads{};  // none: the scene's
  bool again = false;            // also where there is a record
  std::stop_token stop{};
};

struct Attempt {
  enum class Fate {
    made,       // and recorded now
    known,      // recorded before
    elsewhere,  // another program is at it
    stopped     // no record
  };
  Fate fate = Fate::stopped;
  std::optional<Row> row{};  // of those that are recorded
};

// Makes the run and records it in the study's folder, as a process of its own (`tencer design`), so
// that whatever becomes of it - a crash, no memory left, no end - costs one row. No two programs
// make a run at once: its log is locked, by this program and the process that it starts. Error: the
// folder cannot be written to, or the name of the run is another's there.
core::Expected<Attempt> make(const Run& run, const std::filesystem::path& folder,
                             const MakeOptions& options);

}  // namespace tencer::app::study
