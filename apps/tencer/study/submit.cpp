#include "submit.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

namespace tencer::app::study {
namespace {

constexpr int most_tasks = 1000;       // Slurm's MaxArraySize is 1001 if nobody changed it
constexpr double after_limit = 120.0;  // seconds that a run may take for its last checks

// A word as shells read it.
std::string shell_word(const std::string& text) {
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) ||
           std::string("-_./,=+:@%").find(c) != std::string::npos;
  };
  if (!text.empty() && std::ranges::all_of(text, plain)) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

std::string run_line(const Submission& submission, const std::string& number) {
  std::string line = shell_word(submission.program.string()) + " study";
  for (const std::string& word : submission.options) line += ' ' + shell_word(word);
  line += " --run " + number + " --";
  for (const auto& scene : submission.scenes) line += ' ' + shell_word(scene.string());
  return line;
}

std::string collect_line(const Submission& submission) {
  return shell_word(submission.program.string()) + " study --output " +
         shell_word(submission.folder.string()) + " --collect";
}

}  // namespace

std::string slurm_script(const Submission& submission) {
  const int tasks = std::min(submission.runs, most_tasks);
  const int in_turn = (submission.runs + tasks - 1) / tasks;
  const int minutes =
      static_cast<int>(std::ceil(in_turn * (submission.time_limit + after_limit) / 60));
  const std::string logs = (submission.here / submission.folder / "slurm-%A_%a.log").string();
  std::ostringstream text;
  text << "#!/bin/bash\n"
          "# Written by `tencer study --submit slurm`: makes the runs of a study that are not "
          "made.\n"
          "#SBATCH --job-name=tencer-study\n"
       << "#SBATCH --array=1-" << tasks << "\n#SBATCH --cpus-per-task=" << submission.threads
       << "\n#SBATCH --time=" << minutes << "\n#SBATCH --output=" << logs << '\n'
       << "cd " << shell_word(submission.here.string()) << " || exit\n"
       << "failed=0\n"
       << "for ((run = SLURM_ARRAY_TASK_ID; run <= " << submission.runs << "; run += " << tasks
       << ")); do\n  " << run_line(submission, "$run") << " || failed=$?\ndone\n"
       << "exit $failed\n";
  return text.str();
}

std::string parallel_script(const Submission& submission) {
  std::ostringstream text;
  text << "#!/bin/bash\n"
          "# Written by `tencer study --submit parallel`: makes the runs of a study that are not "
          "made, then\n"
          "# table and pictures. Arguments go to GNU parallel.\n"
       << "cd " << shell_word(submission.here.string()) << " || exit\n"
       << "seq " << submission.runs << " | parallel --workdir . --quote \"$@\" "
       << run_line(submission, "{}") << '\n'
       << collect_line(submission) << '\n';
  return text.str();
}

}  // namespace tencer::app::study
