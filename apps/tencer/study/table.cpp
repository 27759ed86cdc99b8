#include "table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <tencer/io/csv.hpp>

namespace tencer::app::study {
namespace {

template <class T>
std::string text_of(const std::optional<T>& value) {
  if (!value) return "";
  if constexpr (std::is_same_v<T, bool>)
    return *value ? "yes" : "no";
  else if constexpr (std::is_same_v<T, int>)
    return std::to_string(*value);
  else
    return number_text(*value);
}

// Reads `text` into `value`; false when it is something else.
template <class T>
bool read(const std::string& text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

bool read(const std::string& text, std::string& value) {
  value = text;
  return true;
}

bool read(const std::string& text, bool& value) {
  value = text == "yes";
  return value || text == "no";
}

template <class T>
bool read(const std::string& text, std::optional<T>& value) {
  if (text.empty()) return true;
  return read(text, value.emplace());
}

constexpr std::string_view stage_prefix = "seconds_";

// The stages of all rows, each once, in the order in which rows have them.
std::vector<std::string> stages_of(std::span<const Row> rows) {
  std::vector<std::string> stages;
  for (const Row& row : rows) {
    auto place = stages.begin();
    for (const auto& [stage, seconds] : row.stages) {
      const auto at = std::ranges::find(stages, stage);
      place = (at != stages.end() ? at : stages.insert(place, stage)) + 1;
    }
  }
  return stages;
}

double seconds_in(const Row& row, const std::string& stage) {
  return std::ranges::find(row.stages, stage, &std::pair<std::string, double>::first)->second;
}

bool has_stage(const Row& row, const std::string& stage) {
  return std::ranges::count(row.stages, stage, &std::pair<std::string, double>::first) > 0;
}

// Number as it is in names: 0.5, 1, 2.
std::string factor(double resolution) { return std::string("x").append(number_text(resolution)); }

}  // namespace

std::string number_text(double number) {
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr};
}

std::string title_of(const Run& run) {
  return run.scene + ", " + run.method + ", " + run.optimizer + ", " + factor(run.resolution) +
         (run.max_error ? ", max error " + number_text(*run.max_error) + " %" : "");
}

std::string folder_of(const Run& run) {
  return run.scene + "-" + run.method + "-" + run.optimizer + "-" + factor(run.resolution) +
         (run.max_error ? "-" + number_text(*run.max_error) + "percent" : "");
}

bool same_run(const Run& a, const Run& b) {
  return a.scene == b.scene && a.method == b.method && a.optimizer == b.optimizer &&
         a.resolution == b.resolution && a.max_error == b.max_error;
}

Row row_of(const Run& run, const model::Design& design, double seconds) {
  Row row{.run = run, .status = io::status_name(design.status), .seconds = seconds};
  row.vertices = 0;
  for (const auto& points : design.target) *row.vertices += static_cast<int>(points.cols());
  row.cables = static_cast<int>(design.structure.cables.size());
  row.external_cables = model::external_cables(design);
  if (design.error) {
    row.max_percent = design.error->max_percent;
    row.rms_percent = design.error->rms_percent;
  }
  if (design.certificate) {
    row.stands = design.certificate->stable;
    row.settles = design.certificate->settles_from_target;
    row.smallest_eigenvalue = design.certificate->smallest_eigenvalue;
  }
  for (const auto& stage : design.trace) {
    if (!has_stage(row, stage.stage)) row.stages.emplace_back(stage.stage, 0.0);
    std::ranges::find(row.stages, stage.stage, &std::pair<std::string, double>::first)->second +=
        stage.seconds;
  }
  return row;
}

std::string table_text(std::span<const Row> rows) {
  const std::vector<std::string> stages = stages_of(rows);
  io::CsvRow header{"scene",       "file",        "method",   "optimizer", "resolution",
                    "max_error",   "status",      "vertices", "cables",    "external_cables",
                    "max_percent", "rms_percent", "stands",   "settles",   "smallest_eigenvalue",
                    "machine",     "seconds"};
  for (const auto& stage : stages) header.push_back(std::string(stage_prefix) + stage);
  header.push_back("message");
  std::string text = io::csv_line(header);
  for (const Row& row : rows) {
    io::CsvRow fields{row.run.scene,
                      row.run.file,
                      row.run.method,
                      row.run.optimizer,
                      number_text(row.run.resolution),
                      text_of(row.run.max_error),
                      row.status,
                      text_of(row.vertices),
                      text_of(row.cables),
                      text_of(row.external_cables),
                      text_of(row.max_percent),
                      text_of(row.rms_percent),
                      text_of(row.stands),
                      text_of(row.settles),
                      text_of(row.smallest_eigenvalue),
                      row.machine,
                      number_text(row.seconds)};
    for (const auto& stage : stages)
      fields.push_back(has_stage(row, stage) ? number_text(seconds_in(row, stage)) : "");
    fields.push_back(row.message);
    text += io::csv_line(fields);
  }
  return text;
}

core::Expected<std::vector<Row>> parse_table(const std::filesystem::path& path,
                                             std::string_view text) {
  const auto lines = io::parse_csv(path, text);
  if (!lines) return lines.error();
  std::vector<Row> rows;
  if (lines->empty()) return rows;
  const io::CsvRow& header = lines->front();
  for (std::size_t i = 1; i < lines->size(); ++i) {
    const std::string where = path.string() + ":" + std::to_string(i + 1);
    const io::CsvRow& fields = (*lines)[i];
    if (fields.size() != header.size())
      return core::Error{where, "expected " + std::to_string(header.size()) +
                                    " fields as in the first line, found " +
                                    std::to_string(fields.size())};
    std::map<std::string, std::string> columns;
    for (std::size_t c = 0; c < fields.size(); ++c) columns[header[c]] = fields[c];
    Row row;
    std::string wrong;
    const auto take = [&](const char* name, auto& value) {
      if (!columns.contains(name) || !read(columns[name], value)) wrong = name;
    };
    take("scene", row.run.scene);
    take("file", row.run.file);
    take("method", row.run.method);
    take("optimizer", row.run.optimizer);
    take("resolution", row.run.resolution);
    take("max_error", row.run.max_error);
    take("status", row.status);
    take("vertices", row.vertices);
    take("cables", row.cables);
    take("external_cables", row.external_cables);
    take("max_percent", row.max_percent);
    take("rms_percent", row.rms_percent);
    take("stands", row.stands);
    take("settles", row.settles);
    take("smallest_eigenvalue", row.smallest_eigenvalue);
    take("machine", row.machine);
    take("seconds", row.seconds);
    take("message", row.message);
    for (std::size_t c = 0; c < fields.size(); ++c) {
      if (!header[c].starts_with(stage_prefix) || fields[c].empty()) continue;
      row.stages.emplace_back(header[c].substr(stage_prefix.size()), 0.0);
      if (!read(fields[c], row.stages.back().second)) wrong = header[c];
    }
    if (!wrong.empty())
      return core::Error{where, wrong +
                                    ": not as a study writes it; name another folder, or remove "
                                    "this table"};
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace tencer::app::study
