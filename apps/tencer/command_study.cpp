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
#include "study/closed_forms.hpp"
#include "study/collect.hpp"
#include "study/draughtsman.hpp"
#include "study/file_lock.hpp"
#include "study/plot.hpp"
#include "study/records.hpp"
#include "study/runs.hpp"
#include "study/submit.hpp"
#include "terminal/activity.hpp"

namespace tencer::app {
namespace {

constexpr const char* study_examples = R"(Examples:
  tencer study examples/paper/*.toml -o study           every scene by both methods
  tencer study knot.obj -o study --methods dense-springs --optimizers ipopt,mma,ccsaq
  tencer study knot.obj -o study --resolutions 0.5,1,2  with half and twice the vertices as well
  tencer study knots/*.obj -o study --max-errors 0.5,1,2,4
                                                        what each error costs in cables
  tencer study --closed-forms -o study                  the solver against known answers
  tencer study knots/*.obj -o study --list              its runs, by number, and which are made
  tencer study knots/*.obj -o study --run 7             one of them; any number of machines at once
  tencer study -o study --collect                       table and pictures of what is made so far
  tencer study knots/*.obj -o study --submit slurm      a script that has a cluster make them

The folder gets study.csv, a line for each run; for each scene a picture of max error against
seconds, SCENE.svg, with the gnuplot script (.gp) and data (.dat) it is drawn from; and in runs/ every
design with what is recorded of its run. A run that fails, or does not end within the time limit, has
a line that says so. Runs that are recorded are not made again, also when a scene has changed since,
unless --again is given: a study that was interrupted goes on where it was, and the same command
given on several machines that share the folder shares out the runs. The closed forms go to
closed-forms.csv and .svg.)";

struct StudyRequest {
  study::Choice choice{.methods = {"force-balance", "dense-springs"}, .resolutions = {1.0}};
  std::vector<std::string> optimizers;
  std::filesystem::path output;
  study::MakeOptions make{.limit = 600.0};
  bool closed_forms = false;  // beside the runs, or alone
  // A part of the study, one at most.
  bool list = false;
  std::optional<int> run;  // its number, from 1
  bool collect = false;
  std::optional<std::string> submit;  // to whom
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
                                              const Console& console) {
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
  for (const auto& row : rows)
    curve_of(plot, row.problem)
        .points.push_back({.seconds = row.seconds, .error = row.error, .count = row.edges});
  const auto lock = study::FileLock::in_turn(study::gnuplot_log(folder));
  if (!lock) return lock.error();
  return study::Draughtsman(folder, console.log())
      .draw("closed-forms", plot_files("closed-forms", plot));
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

// The runs by number, and what has become of them.
core::Expected<ExitCode> list_runs(std::span<const study::Run> runs,
                                   const std::filesystem::path& folder) {
  int number = 0;
  for (const study::Run& run : runs) {
    const auto row = study::recorded(run, folder);
    if (!row) return row.error();
    std::cout << ++number << '\t' << title_of(run) << '\t' << (*row ? (*row)->status : "not made")
              << '\n';
  }
  return ExitCode::ok;
}

std::string comma_list(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

std::string comma_list(const std::vector<double>& numbers) {
  std::vector<std::string> words;
  std::ranges::transform(numbers, std::back_inserter(words), study::number_text);
  return comma_list(words);
}

core::Expected<ExitCode> submit_runs(const StudyRequest& request, int runs,
                                     const Console& console) {
  study::Submission submission{.here = std::filesystem::current_path(),
                               .program = std::filesystem::read_symlink("/proc/self/exe"),
                               .scenes = request.choice.scenes,
                               .folder = request.output,
                               .runs = runs,
                               .threads = request.make.threads.value_or(1),
                               .time_limit = request.make.limit};
  const auto add = [&](const std::string& option, const std::string& value) {
    if (!value.empty()) submission.options.insert(submission.options.end(), {option, value});
  };
  add("--output", request.output.string());
  add("--methods", comma_list(request.choice.methods));
  add("--optimizers", comma_list(request.optimizers));
  add("--resolutions", comma_list(request.choice.resolutions));
  add("--max-errors", comma_list(request.choice.max_errors));
  add("--time-limit", study::number_text(request.make.limit));
  add("--threads", std::to_string(submission.threads));
  if (request.make.again) submission.options.emplace_back("--again");

  const bool slurm = *request.submit == "slurm";
  const auto script = request.output / (slurm ? "slurm.sh" : "parallel.sh");
  std::filesystem::create_directories(request.output);
  if (const auto error =
          io::write_file(script, slurm ? slurm_script(submission) : parallel_script(submission)))
    return *error;
  console.say((slurm ? "sbatch " : "bash ") + script.string() + '\n');
  if (slurm)
    console.say("and when its tasks are done: tencer study -o " + request.output.string() +
                " --collect\n");
  return ExitCode::ok;
}

// What is not as asked, in words and as the exit code.
ExitCode conclude(std::span<const study::Row> rows, const std::filesystem::path& folder,
                  const Console& console) {
  const auto short_of = static_cast<int>(
      std::ranges::count_if(rows, [](const auto& row) { return row.status != "complete"; }));
  if (short_of > 0)
    console.say(core::counted(short_of, "run") + (short_of == 1 ? " is" : " are") +
                " not complete; the table says why\n");
  if (!rows.empty()) console.say("see " + (folder / "study.csv").string() + '\n');
  return short_of > 0 ? ExitCode::tolerance_not_reached : ExitCode::ok;
}

// Makes a run, unless it is there or others are at it, and says which.
core::Expected<study::Attempt> attempt(const study::Run& run, const StudyRequest& request,
                                       const Console& console) {
  using Fate = study::Attempt::Fate;
  Activity activity(console, title_of(run));
  auto made = study::make(run, request.output, request.make);
  activity.end();
  if (!made) return made;
  if (made->fate == Fate::made) console.say(line_of(*made->row) + '\n');
  if (made->fate == Fate::known) console.log()(core::Level::info, title_of(run) + ": done before");
  if (made->fate == Fate::elsewhere)
    console.log()(core::Level::info, title_of(run) + ": another program is at it");
  std::cout.flush();
  return made;
}

core::Expected<ExitCode> make_one(std::span<const study::Run> runs, const StudyRequest& request,
                                  const Console& console) {
  const auto count = static_cast<int>(runs.size());
  if (*request.run > count)
    return core::Error{"--run", "expected 1 to " + std::to_string(count) +
                                    ", as --list numbers them, found " +
                                    std::to_string(*request.run)};
  const auto made = attempt(runs[static_cast<std::size_t>(*request.run - 1)], request, console);
  if (!made) return made.error();
  return made->row ? ExitCode::ok : ExitCode::tolerance_not_reached;
}

core::Expected<ExitCode> make_all(std::span<const study::Run> runs, const StudyRequest& request,
                                  const Console& console) {
  const std::filesystem::path& folder = request.output;
  if (request.closed_forms)
    if (const auto error = study_closed_forms(folder, console)) return *error;
  if (runs.empty()) return ExitCode::ok;
  std::vector<study::Row> rows;
  int elsewhere = 0;
  for (const study::Run& run : runs) {
    const auto made = attempt(run, request, console);
    if (!made) return made.error();
    if (made->fate == study::Attempt::Fate::stopped) break;
    if (made->row)
      rows.push_back(*made->row);
    else
      ++elsewhere;
  }
  if (const auto all = study::collect(folder, console.log()); !all) return all.error();
  const bool stopped = rows.size() + static_cast<std::size_t>(elsewhere) < runs.size();
  if (stopped) console.say("interrupted: the same command goes on from here\n");
  if (elsewhere > 0)
    console.say("others are at " + core::counted(elsewhere, "run") +
                "; when these are done: tencer study -o " + folder.string() + " --collect\n");
  const ExitCode code = conclude(rows, folder, console);
  return stopped || elsewhere > 0 ? ExitCode::tolerance_not_reached : code;
}

core::Expected<ExitCode> collect_runs(const StudyRequest& request, const Console& console) {
  if (!request.choice.scenes.empty())
    return core::Error{"SCENES", "--collect takes what is recorded in the folder; name no scenes"};
  if (!std::filesystem::is_directory(request.output / "runs"))
    return core::Error{request.output.string(), "there are no runs of a study in it"};
  const auto rows = study::collect(request.output, console.log());
  if (!rows) return rows.error();
  return conclude(*rows, request.output, console);
}

core::Expected<ExitCode> run_study(StudyRequest request, const Console& console) {
  if (request.collect) return collect_runs(request, console);
  const bool whole = !request.list && !request.run && !request.submit;
  if (request.choice.scenes.empty() && !(request.closed_forms && whole))
    return core::Error{"SCENES", "name scenes or curves to study, or give --closed-forms"};
  if (const auto error = choose_optimizers(request.optimizers, request.choice)) return *error;
  const auto runs = study::runs_of(request.choice);
  if (!runs) return runs.error();
  if (request.list) return list_runs(*runs, request.output);
  if (const auto error = io::folder_problem(request.output)) return *error;
  if (request.submit) return submit_runs(request, static_cast<int>(runs->size()), console);
  std::filesystem::create_directories(request.output);
  const Interrupt interrupt;
  request.make.stop = interrupt.token();
  return request.run ? make_one(*runs, request, console) : make_all(*runs, request, console);
}

// What is done of a study, if not all.
void add_parts(CLI::App& command, StudyRequest& request) {
  const std::array parts{
      command.add_flag("--list", request.list, "List the runs by number, and which are made"),
      command.add_option("--run", request.run, "Make the run of this number and record it")
          ->check(positive_integer()),
      command.add_flag("--collect", request.collect,
                       "Make table and pictures of what is recorded in the folder"),
      command
          .add_option("--submit", request.submit,
                      "Write a script that has other machines make the runs")
          ->check(one_of({"slurm", "parallel"})),
      command.add_flag("--closed-forms", request.closed_forms,
                       "Compare the forward solver with closed forms")};
  for (CLI::Option* one : parts)
    for (CLI::Option* other : parts)
      if (one != other) one->excludes(other);
}

}  // namespace

void add_study(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "study", "Compare methods, optimizers and resolutions: error against run time");
  command->footer(study_examples);
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
      ->add_option("--max-errors", request->choice.max_errors,
                   "Largest distances to the target, % of its size [the scenes' own]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(positive_number());
  command
      ->add_option("--time-limit", request->make.limit,
                   "Seconds until a run has to end with the best design so far")
      ->check(positive_number())
      ->capture_default_str();
  command
      ->add_option("--threads", request->make.threads,
                   "How many threads a run has [the scene's, else as many as the machine has; with "
                   "--submit 1]")
      ->check(positive_integer());
  command->add_flag("--again", request->make.again, "Make also the runs that are recorded");
  add_parts(*command, *request);
  command->callback([&chosen, request] {
    chosen = [request](const Console& console) { return run_study(*request, console); };
  });
}

}  // namespace tencer::app
