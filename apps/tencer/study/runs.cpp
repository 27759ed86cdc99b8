#include "runs.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <sstream>
#include <system_error>
#include <tencer/io/file.hpp>
#include <tencer/io/scene.hpp>

#include "child.hpp"

namespace tencer::app::study {
namespace {

namespace fs = std::filesystem;

fs::path runs_folder(const fs::path& folder) { return folder / "runs"; }
fs::path log_of(const fs::path& folder, const Run& run) {
  return runs_folder(folder) / (folder_of(run) + ".log");
}
fs::path design_of(const fs::path& folder, const Run& run) {
  return runs_folder(folder) / folder_of(run) / "design.json";
}

std::string short_text(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

// What the program said last of what went wrong, without its name.
std::string complaint(const fs::path& log) {
  const auto text = io::read_file(log);
  if (!text) return "";
  std::istringstream lines(*text);
  std::string found;
  for (std::string line; std::getline(lines, line);)
    for (const std::string start : {"tencer: ", "not complete: "})
      if (line.starts_with(start)) found = line.substr(start.size());
  return found;
}

Row failed(const Run& run, const ChildEnd& end, const fs::path& log, double limit) {
  Row row{.run = run, .status = "failed", .seconds = end.seconds};
  if (end.timed_out)
    row.message = "no design within the time limit of " + short_text(limit) + " s";
  else if (const char* signal = sigdescr_np(end.signal); end.signal != 0)
    row.message = "ended by a signal: " + (signal ? signal : std::to_string(end.signal));
  else
    row.message = complaint(log);
  if (row.message.empty()) row.message = "exit code " + std::to_string(end.exit_code);
  return row;
}

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

}  // namespace

core::Expected<std::vector<Run>> runs_of(const Choice& choice) {
  std::vector<Run> runs;
  std::map<std::string, fs::path> files;
  for (const fs::path& file : choice.scenes) {
    const std::string name = file.stem().string();
    const auto [known, added] = files.try_emplace(name, file);
    if (!added)
      return core::Error{file.string(), "has the name of " + known->second.string() +
                                            ", by which a study knows its scenes; study one of "
                                            "them in a folder of its own"};
    for (const std::string& method : choice.methods) {
      for (const std::string& optimizer :
           method == "force-balance" ? choice.force_balance : choice.dense_springs)
        for (const double resolution : choice.resolutions)
          runs.push_back({.scene = name,
                          .file = file.string(),
                          .method = method,
                          .optimizer = optimizer,
                          .resolution = resolution});
    }
  }
  return runs;
}

std::optional<Row> make(const Run& run, const fs::path& folder, double limit,
                        const std::stop_token& stop) {
  fs::create_directories(runs_folder(folder));
  const fs::path log = log_of(folder, run);
  std::vector<std::string> arguments{
      "design",      "--output",     design_of(folder, run).parent_path().string(),
      "--method",    run.method,     "--optimizer",
      run.optimizer, "--resolution", short_text(run.resolution)};
  arguments.push_back("--");
  arguments.push_back(run.file);
  const ChildEnd end =
      run_child("/proc/self/exe", arguments, {.log = log, .limit = limit, .stop = stop});
  if (stop.stop_requested()) return std::nullopt;
  if (end.exit_code != 0 && end.exit_code != 3) return failed(run, end, log, limit);
  const auto design = io::read_design(design_of(folder, run));
  if (!design)
    return Row{
        .run = run, .status = "failed", .seconds = end.seconds, .message = design.error().text()};
  Row row = row_of(run, *design, end.seconds);
  if (design->status == model::DesignStatus::interrupted)
    row.message = "interrupted at the time limit of " + short_text(limit) + " s";
  else if (design->status != model::DesignStatus::complete)
    row.message = complaint(log);
  return row;
}

Plot plot_of(const std::string& scene, std::span<const Row> rows, const fs::path& folder) {
  std::vector<const Row*> found;
  std::set<double> resolutions;
  for (const Row& row : rows)
    if (row.run.scene == scene) {
      resolutions.insert(row.run.resolution);
      if (row.cables) found.push_back(&row);
    }
  const bool several = resolutions.size() > 1;
  std::ranges::stable_sort(found, {}, [](const Row* row) { return row->run.resolution; });

  Plot plot{.title = scene + (several ? ", a point a resolution" : ""),
            .error_axis = "max error, % of the size",
            .count_axis = "cables"};
  if (!found.empty())
    if (const auto asked = io::read_any_scene(found.front()->run.file))
      plot.allowed = asked->design.max_error;
  for (const Row* row : found) {
    const std::string name = row->run.method + ", " + row->run.optimizer;
    auto curve = std::ranges::find(plot.curves, name, &PlotCurve::name);
    if (curve == plot.curves.end()) {
      const int colour = static_cast<int>(plot.curves.size()) + 1;
      curve = plot.curves.insert(curve, {.name = name, .colour = colour});
    }
    PlotPoint design{
        .seconds = row->seconds, .error = row->max_percent.value_or(0.0), .count = *row->cables};
    if (!several)
      if (const auto file = io::read_design(design_of(folder, row->run)))
        curve->points = stages(*file);
    curve->points.push_back(design);
  }
  return plot;
}

}  // namespace tencer::app::study
