// tencer study: error against run time, over scenes, methods, optimizers and resolutions.
#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <set>
#include <sstream>
#include <tencer/core/words.hpp>
#include <tencer/io/file.hpp>
#include <tencer/pipeline/backends.hpp>

#include "command.hpp"
#include "interrupt.hpp"
#include "study/child.hpp"
#include "study/closed_forms.hpp"
#include "study/folder_lock.hpp"
#include "study/runs.hpp"
#include "terminal/activity.hpp"

namespace tencer::app {
namespace {

constexpr const char* examples = R"(Examples:
  tencer study examples/paper/*.toml -o study           every scene by both methods
  tencer study knot.obj -o study --methods dense-springs --optimizers ipopt,mma,ccsaq
  tencer study knot.obj -o study --resolutions 0.5,1,2  with half and twice the vertices as well
  tencer study --closed-forms -o study                  the solver against known answers

The folder gets study.csv, a line for each run; for each scene a picture of max error against
seconds, SCENE.svg, with the gnuplot script (.gp) and data (.dat) it is drawn from; and in runs/ every
design. A run that fails, or does not end within the time limit, has a line that says so. Lines that
are there are not made again, also when a scene has changed since, unless --again is given: a study
that was interrupted goes on where it was. The closed forms go to closed-forms.csv and .svg.)";

struct StudyRequest {
  study::Choice choice{.methods = {"force-balance", "dense-springs"}, .resolutions = {1.0}};
  std::vector<std::string> optimizers;
  std::filesystem::path output;
  double time_limit = 600.0;
  bool again = false;
  bool closed_forms = false;
};

// Writes the plot's files and has gnuplot draw it; what went wrong goes to the log.
class Draughtsman {
 public:
  Draughtsman(const std::filesystem::path& folder, const core::Log& log)
      : folder_(folder), log_(log) {}

  std::optional<core::Error> draw(const std::string& name, const study::Plot& plot) {
    if (!study::has_points(plot)) return std::nullopt;
    if (auto error = io::write_files(folder_, study::plot_files(name, plot))) return error;
    if (missing_) return std::nullopt;
    const auto end = study::run_child("gnuplot", {name + ".gp"},
                                      {.folder = folder_, .log = folder_ / "gnuplot.log"});
    missing_ = !end.found;
    if (missing_)
      log_(
          core::Level::warning,
          "there is no gnuplot (in Debian the package gnuplot-nox), so no pictures are drawn; with "
          "it, `gnuplot " +
              name + ".gp` in " + folder_.string() + " draws this one");
    else if (end.exit_code != 0)
      log_(core::Level::warning,
           "gnuplot could not draw " + name + ".gp; see " + (folder_ / "gnuplot.log").string());
    return std::nullopt;
  }

 private:
  std::filesystem::path folder_;
  const core::Log& log_;
  bool missing_ = false;
};

// A finished run on the terminal.
std::string line_of(const study::Row& row) {
  std::ostringstream line;
  line << title_of(row.run) << ": " << std::setprecision(3);
  if (row.cables) line << core::counted(*row.cables, "cable") << ", ";
  if (row.max_percent) line << "max error " << *row.max_percent << " %, ";
  line << row.seconds << " s";
  if (row.status != "complete") line << "; " << row.status;
  if (!row.message.empty()) line << ": " << row.message;
  return line.str();
}

std::optional<core::Error> study_closed_forms(const std::filesystem::path& folder,
                                              Draughtsman& draughtsman, const Console& console) {
  constexpr std::array edges{10, 20, 40, 80, 160, 320, 640};
  const auto rows = study::closed_form_errors(edges, [&](const study::Accuracy& row) {
    std::ostringstream line;
    line << row.problem << ", " << row.edges << " edges: relative error " << std::setprecision(3)
         << row.error << ", " << row.seconds * 1e3 << " ms\n";
    console.say(line.str());
  });
  if (auto error = io::write_file(folder / "closed-forms.csv", study::accuracy_text(rows)))
    return error;
  study::Plot plot{.title = "The forward solver against closed forms",
                   .error_axis = "relative error",
                   .count_axis = "edges"};
  for (const auto& row : rows) {
    if (plot.curves.empty() || plot.curves.back().name != row.problem)
      plot.curves.push_back(
          {.name = row.problem, .colour = static_cast<int>(plot.curves.size()) + 1});
    plot.curves.back().points.push_back(
        {.seconds = row.seconds, .error = row.error, .count = row.edges});
  }
  return draughtsman.draw("closed-forms", plot);
}

core::Expected<std::vector<study::Row>> rows_so_far(const std::filesystem::path& table) {
  if (!std::filesystem::exists(table)) return std::vector<study::Row>{};
  const auto text = io::read_file(table);
  if (!text) return text.error();
  return study::parse_table(table, *text);
}

// Sets the choice's optimizers of each method: those asked for; else for dense-springs those that
// the paper's route is known with, as far as this build has them, and for force-balance its own.
std::optional<core::Error> choose_optimizers(const std::vector<std::string>& asked,
                                             study::Choice& choice) {
  const auto backends = pipeline::backends();
  for (const auto& name : asked)
    if (const auto known = optimize::find_backend(backends, name); !known)
      return core::Error{"--optimizers", known.error().message};
  choice.dense_springs = choice.force_balance = asked;
  if (!asked.empty()) return std::nullopt;
  choice.force_balance = {std::string(model::name_of(model::Optimizer::gauss_newton))};
  for (const std::string name : {"ipopt", "mma"})
    if (optimize::find_backend(backends, name)) choice.dense_springs.push_back(name);
  if (choice.dense_springs.empty()) choice.dense_springs.push_back(backends.front().name);
  return std::nullopt;
}

core::Expected<ExitCode> run_study(StudyRequest request, const Console& console) {
  if (request.choice.scenes.empty() && !request.closed_forms)
    return core::Error{"SCENES", "name scenes or curves to study, or give --closed-forms"};
  if (const auto error = choose_optimizers(request.optimizers, request.choice)) return *error;
  const auto runs = study::runs_of(request.choice);
  if (!runs) return runs.error();
  const std::filesystem::path& folder = request.output;
  if (const auto error = io::folder_problem(folder)) return *error;
  const std::filesystem::path table = folder / "study.csv";
  auto rows = rows_so_far(table);
  if (!rows) return rows.error();
  std::filesystem::create_directories(folder);
  const study::FolderLock lock(folder);
  if (lock.problem()) return *lock.problem();

  const Interrupt interrupt;
  Draughtsman draughtsman(folder, console.log());
  if (request.closed_forms)
    if (const auto error = study_closed_forms(folder, draughtsman, console)) return *error;
  int short_of = 0;
  for (auto run = runs->begin(); run != runs->end() && !interrupt.token().stop_requested(); ++run) {
    auto row = std::ranges::find_if(
        *rows, [&](const study::Row& one) { return study::same_run(one.run, *run); });
    if (row != rows->end() && row->run.file != run->file)
      return core::Error{run->file, "has the name of " + row->run.file + " in " + table.string() +
                                        "; name another folder"};
    if (row != rows->end() && !request.again) {
      console.log()(core::Level::info, title_of(*run) + ": done before");
    } else {
      Activity activity(console, title_of(*run));
      auto made = study::make(*run, folder, request.time_limit, interrupt.token());
      if (!made) break;
      activity.end();
      console.say(line_of(*made) + '\n');
      std::cout.flush();
      row =
          row == rows->end() ? rows->insert(row, std::move(*made)) : (*row = std::move(*made), row);
      if (const auto error = io::write_file(table, study::table_text(*rows))) return *error;
    }
    if (row->status != "complete") ++short_of;
    if (run + 1 == runs->end() || (run + 1)->scene != run->scene)
      if (const auto error =
              draughtsman.draw(run->scene, study::plot_of(run->scene, *rows, folder)))
        return *error;
  }
  if (interrupt.token().stop_requested())
    console.say("interrupted: the same command goes on from here\n");
  if (short_of > 0)
    console.say(core::counted(short_of, "run") + (short_of == 1 ? " is" : " are") +
                " not complete; the table says why\n");
  if (!rows->empty()) console.say("see " + table.string() + '\n');
  return short_of > 0 || interrupt.token().stop_requested() ? ExitCode::tolerance_not_reached
                                                            : ExitCode::ok;
}

}  // namespace

void add_study(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "study", "Compare methods, optimizers and resolutions: error against run time");
  command->footer(examples);
  const auto request = std::make_shared<StudyRequest>();
  command->add_option("SCENES", request->choice.scenes, "Scenes (.toml) or target curves");
  command->add_option("-o,--output", request->output, "Folder for table, pictures and designs")
      ->required();
  command
      ->add_option("--methods", request->choice.methods, "Ways to a network, with commas between")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(one_of({"force-balance", "dense-springs"}))
      ->capture_default_str();
  command
      ->add_option("--optimizers", request->optimizers,
                   "Outer optimizers [ipopt,mma for dense-springs, gauss-newton for force-balance]")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option("--resolutions", request->choice.resolutions,
                   "Vertices of every rod, times what the scene has")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(positive_number())
      ->check(CLI::Range(0.01, 100.0))
      ->capture_default_str();
  command
      ->add_option("--time-limit", request->time_limit,
                   "Seconds until a run has to end with the best design so far")
      ->check(positive_number())
      ->capture_default_str();
  command->add_flag("--again", request->again, "Make also the runs that are in the table");
  command->add_flag("--closed-forms", request->closed_forms,
                    "Compare the forward solver with closed forms");
  command->callback([&chosen, request] {
    chosen = [request](const Console& console) { return run_study(*request, console); };
  });
}

}  // namespace tencer::app
