// Scripts that have the runs of a study made by many machines.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tencer::app::study {

struct Submission {
  std::filesystem::path here{};        // the folder in which the command is given, absolute
  std::filesystem::path program{};     // absolute
  std::vector<std::string> options{};  // what the study is asked for, but for its scenes
  std::vector<std::filesystem::path> scenes{};
  std::filesystem::path folder{};  // of the study, as the command has it
  int runs = 0;
  int threads = 1;          // of a run
  double time_limit = 0.0;  // of a run, seconds
};

// An array job for Slurm (sbatch): at most 1000 tasks, as many as Slurm's default allows, each of
// which makes one run after the other, every 1000th.
std::string slurm_script(const Submission& submission);

// All runs by GNU parallel, as many at a time as there are cores, and then table and pictures. What
// the script is given goes to parallel: -j 4, or -S a,b.
std::string parallel_script(const Submission& submission);

}  // namespace tencer::app::study
