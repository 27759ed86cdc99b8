#include "runs.hpp"

#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>
#include <map>
#include <sstream>
#include <tencer/io/file.hpp>

#include "child.hpp"
#include "file_lock.hpp"
#include "records.hpp"

namespace tencer::app::study {
namespace {

namespace fs = std::filesystem;

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
    row.message = "no design within the time limit of " + number_text(limit) + " s";
  else if (const char* signal = sigdescr_np(end.signal); end.signal != 0)
    row.message = "ended by a signal: " + (signal ? signal : std::to_string(end.signal));
  else
    row.message = complaint(log);
  if (row.message.empty()) row.message = "exit code " + std::to_string(end.exit_code);
  return row;
}

// The run's row, whatever became of its process; none when it was stopped.
std::optional<Row> design_row(const Run& run, const fs::path& folder, const MakeOptions& options,
                              const FileLock& lock) {
  const fs::path log = log_of(folder, run);
  const fs::path design_file = design_of(folder, run);
  std::vector<std::string> arguments{
      "design",      "--output",     design_file.parent_path().string(),
      "--method",    run.method,     "--optimizer",
      run.optimizer, "--resolution", number_text(run.resolution)};
  if (run.max_error)
    arguments.insert(arguments.end(), {"--max-error", number_text(*run.max_error)});
  if (options.threads)
    arguments.insert(arguments.end(), {"--threads", std::to_string(*options.threads)});
  arguments.insert(arguments.end(), {"--", run.file});
  const ChildEnd end = run_child(
      "/proc/self/exe", arguments,
      {.log = log, .limit = options.limit, .kept = lock.descriptor(), .stop = options.stop});
  // Whoever asked the process to end may ask us next: clusters ask all.
  const bool stopped = end.signal == SIGTERM && !end.timed_out;
  if (options.stop.stop_requested() || stopped) return std::nullopt;
  if (end.exit_code != 0 && end.exit_code != 3) return failed(run, end, log, options.limit);
  const auto design = io::read_design(design_file);
  if (!design)
    return Row{
        .run = run, .status = "failed", .seconds = end.seconds, .message = design.error().text()};
  const bool interrupted = design->status == model::DesignStatus::interrupted;
  if (interrupted && !end.timed_out) return std::nullopt;
  Row row = row_of(run, *design, end.seconds);
  if (interrupted)
    row.message = "interrupted at the time limit of " + number_text(options.limit) + " s";
  else if (design->status != model::DesignStatus::complete)
    row.message = complaint(log);
  return row;
}

std::string machine_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

}  // namespace

core::Expected<std::vector<Run>> runs_of(const Choice& choice) {
  std::vector<std::optional<double>> max_errors(choice.max_errors.begin(), choice.max_errors.end());
  if (max_errors.empty()) max_errors.emplace_back();
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
          for (const auto& max_error : max_errors)
            runs.push_back({.scene = name,
                            .file = file.string(),
                            .method = method,
                            .optimizer = optimizer,
                            .resolution = resolution,
                            .max_error = max_error});
    }
  }
  return runs;
}

core::Expected<Attempt> make(const Run& run, const fs::path& folder, const MakeOptions& options) {
  fs::create_directories(log_of(folder, run).parent_path());
  const auto lock = FileLock::at_once(log_of(folder, run));
  if (!lock) return lock.error();
  if (!*lock) return Attempt{.fate = Attempt::Fate::elsewhere};
  auto known = recorded(run, folder);
  if (!known) return known.error();
  if (*known && !options.again)
    return Attempt{.fate = Attempt::Fate::known, .row = std::move(*known)};
  auto row = design_row(run, folder, options, **lock);
  if (!row) return Attempt{.fate = Attempt::Fate::stopped};
  row->machine = machine_name();
  if (auto error = record(*row, folder)) return *error;
  return Attempt{.fate = Attempt::Fate::made, .row = std::move(row)};
}
}  // namespace tencer::app::study
