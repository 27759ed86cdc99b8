#include <array>
#include <cmath>
#include <tencer/io/csv.hpp>
#include <tencer/io/file.hpp>
#include <tencer/io/trace.hpp>

#include "text/text.hpp"

namespace tencer::io {
namespace {

std::string percent(double value) { return std::isnan(value) ? "" : to_text(value); }

}  // namespace

std::string trace_text(std::span<const model::StageRow> rows) {
  std::string text =
      "stage,seconds,cables,max_percent,rms_percent,equilibrium_solves,newton_iterations,note\n";
  for (const model::StageRow& row : rows)
    text +=
        csv_line(std::array{row.stage, to_text(row.seconds), std::to_string(row.cables),
                            percent(row.max_percent), percent(row.rms_percent),
                            std::to_string(row.solves), std::to_string(row.iterations), row.note});
  return text;
}

std::optional<core::Error> write_trace(const std::filesystem::path& path,
                                       std::span<const model::StageRow> rows) {
  return write_file(path, trace_text(rows));
}

}  // namespace tencer::io
