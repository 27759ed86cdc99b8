// The record of error against run time: one row a stage.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <tencer/core/error.hpp>

namespace tencer::io {

struct TraceRow {
  std::string stage;
  double seconds = 0.0;  // spent in this stage
  int cables = 0;        // at its end
  // Largest and root-mean-square distance of the vertices to the target, in percent of its
  // bounding-box diagonal. NaN where the stage has none: an empty field, null in JSON.
  double max_percent = 0.0;
  double rms_percent = 0.0;
  int equilibrium_solves = 0;
  int newton_iterations = 0;
  std::string note;
};

// CSV: a header line and one line a row: commas, quotes as in RFC 4180, doubles that round-trip.
std::string trace_text(std::span<const TraceRow> rows);
std::optional<core::Error> write_trace(const std::filesystem::path& path,
                                       std::span<const TraceRow> rows);

}  // namespace tencer::io
