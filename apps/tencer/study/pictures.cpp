#include "pictures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tencer/io/scene.hpp>
#include <tuple>

#include "records.hpp"

namespace tencer::app::study {
namespace {

// The way to a design: where each stage ended, unless nothing had changed. Without the last one,
// the design itself.
std::vector<PlotPoint> stages(const model::Design& design) {
  std::vector<PlotPoint> points;
  double seconds = 0;
  int cables = -1;
  for (const auto& stage : design.trace) {
    seconds += stage.seconds;
    if (stage.stage == "settle") continue;  // a test of what is there
    if (stage.cables != cables || stage.max_percent != points.back().error)
      points.push_back({.seconds = seconds, .error = stage.max_percent, .count = stage.cables});
    cables = stage.cables;
  }
  if (cables == static_cast<int>(design.structure.cables.size()) && points.size() > 1)
    points.pop_back();
  return points;
}

// The error that the run was allowed; none where its scene cannot be read any more.
std::optional<double> allowed_error(const Run& run) {
  if (run.max_error) return run.max_error;
  const auto scene = io::read_any_scene(run.file);
  if (!scene) return std::nullopt;
  return scene->design.max_error;
}

std::string way_of(const Run& run) { return run.method + ", " + run.optimizer; }

// The least number that so many of all these are not above; none where they have no number.
std::optional<double> quantile(std::vector<double> numbers, double part) {
  std::ranges::sort(numbers);
  const auto last = static_cast<double>(numbers.size()) - 1;
  const double found = numbers[static_cast<std::size_t>(std::ceil(part * last))];
  if (std::isfinite(found)) return found;
  return std::nullopt;
}

}  // namespace

Plot plot_of(const std::string& scene, std::span<const Row> rows,
             const std::filesystem::path& folder) {
  std::vector<const Row*> found;
  std::set<double> resolutions;
  std::set<std::optional<double>> max_errors;
  for (const Row& row : rows)
    if (row.run.scene == scene) {
      resolutions.insert(row.run.resolution);
      max_errors.insert(row.run.max_error);
      if (row.cables) found.push_back(&row);
    }
  const bool several = resolutions.size() > 1 || max_errors.size() > 1;
  std::ranges::stable_sort(found, {}, [](const Row* row) { return row->run.resolution; });

  Plot plot{.title = scene + (resolutions.size() > 1 ? ", a point a resolution" : "") +
                     (max_errors.size() > 1 ? ", a point a max error" : ""),
            .error_axis = "max error, % of the size",
            .count_axis = "cables"};
  if (!found.empty() && max_errors.size() == 1) plot.allowed = allowed_error(found.front()->run);
  for (const Row* row : found) {
    PlotCurve& curve = curve_of(plot, way_of(row->run));
    if (!several)
      if (const auto file = io::read_design(design_of(folder, row->run)))
        curve.points = stages(*file);
    curve.points.push_back(
        {.seconds = row->seconds, .error = row->max_percent.value_or(0.0), .count = *row->cables});
  }
  return plot;
}

CountPlot cables_plot(std::span<const Row> rows) {
  std::map<std::string, std::map<double, std::vector<double>>> cables;  // of each way, by max error
  std::set<double> asked;
  for (const Row& row : rows) {
    if (!row.run.max_error) continue;
    asked.insert(*row.run.max_error);
    cables[way_of(row.run)][*row.run.max_error].push_back(
        row.status == "complete" && row.cables ? *row.cables
                                               : std::numeric_limits<double>::infinity());
  }
  CountPlot plot{.title = "What an error costs",
                 .x_axis = "max error asked for, % of the size",
                 .count_axis = "cables"};
  if (asked.size() < 2) return plot;
  int colour = 0;
  for (const auto& [way, by_error] : cables) {
    ++colour;
    for (const auto& [part, dashes, name] :
         {std::tuple(0.9, 2, "9 in 10 need no more"), {0.5, 1, "half"}, {0.1, 3, "1 in 10"}}) {
      CountCurve curve{.name = way + ": " + name, .colour = colour, .dashes = dashes};
      for (const auto& [max_error, numbers] : by_error)
        if (const auto number = quantile(numbers, part))
          curve.points.emplace_back(max_error, *number);
      if (!curve.points.empty()) plot.curves.push_back(std::move(curve));
    }
  }
  return plot;
}

}  // namespace tencer::app::study
