#include "collect.hpp"

#include <set>
#include <tencer/io/file.hpp>

#include "draughtsman.hpp"
#include "file_lock.hpp"
#include "pictures.hpp"
#include "records.hpp"

namespace tencer::app::study {

core::Expected<std::vector<Row>> collect(const std::filesystem::path& folder,
                                         const core::Log& log) {
  const auto lock = FileLock::in_turn(gnuplot_log(folder));
  if (!lock) return lock.error();
  auto rows = all_records(folder);
  if (!rows) return rows;
  if (auto error = io::write_file(folder / "study.csv", table_text(*rows))) return *error;
  Draughtsman draughtsman(folder, log);
  std::set<std::string> scenes;
  for (const Row& row : *rows) scenes.insert(row.run.scene);
  for (const std::string& scene : scenes)
    if (const Plot plot = plot_of(scene, *rows, folder); has_points(plot))
      if (auto error = draughtsman.draw(scene, plot_files(scene, plot))) return *error;
  if (const CountPlot plot = cables_plot(*rows); !plot.curves.empty())
    if (auto error = draughtsman.draw("study-cables", count_files("study-cables", plot)))
      return *error;
  return rows;
}

}  // namespace tencer::app::study
