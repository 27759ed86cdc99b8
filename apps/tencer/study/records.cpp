#include "records.hpp"

#include <algorithm>
#include <tencer/io/file.hpp>
#include <tuple>

namespace tencer::app::study {
namespace {

namespace fs = std::filesystem;

fs::path runs_folder(const fs::path& folder) { return folder / "runs"; }

// The rows of a record: one, or none where a machine crashed before it was on the disk.
core::Expected<std::vector<Row>> read_record(const fs::path& path) {
  const auto text = io::read_file(path);
  if (!text) return text.error();
  return parse_table(path, *text);
}

}  // namespace

fs::path design_of(const fs::path& folder, const Run& run) {
  return runs_folder(folder) / folder_of(run) / "design.json";
}

fs::path log_of(const fs::path& folder, const Run& run) {
  return runs_folder(folder) / (folder_of(run) + ".log");
}

fs::path record_of(const fs::path& folder, const Run& run) {
  return runs_folder(folder) / (folder_of(run) + ".csv");
}

core::Expected<std::optional<Row>> recorded(const Run& run, const fs::path& folder) {
  const fs::path path = record_of(folder, run);
  if (!fs::exists(path)) return std::optional<Row>();
  auto rows = read_record(path);
  if (!rows) return rows.error();
  if (rows->empty()) return std::optional<Row>();
  Row& row = rows->front();
  if (!same_run(row.run, run) || row.run.file != run.file)
    return core::Error{run.file, "has the name of " + row.run.file + " in " + path.string() +
                                     "; name another folder"};
  return std::optional<Row>(std::move(row));
}

std::optional<core::Error> record(const Row& row, const fs::path& folder) {
  return io::write_file(record_of(folder, row.run), table_text(std::span(&row, 1)));
}

core::Expected<std::vector<Row>> all_records(const fs::path& folder) {
  std::vector<Row> all;
  if (!fs::is_directory(runs_folder(folder))) return all;
  for (const auto& entry : fs::directory_iterator(runs_folder(folder))) {
    if (entry.path().extension() != ".csv") continue;
    auto rows = read_record(entry.path());
    if (!rows) return rows.error();
    std::ranges::move(*rows, std::back_inserter(all));
  }
  std::ranges::sort(all, {}, [](const Row& row) {
    return std::tie(row.run.scene, row.run.method, row.run.optimizer, row.run.resolution,
                    row.run.max_error);
  });
  return all;
}

}  // namespace tencer::app::study
