// Another program, run to its end or to a limit.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace tencer::app::study {

struct ChildOptions {
  std::filesystem::path folder{};  // where it runs; empty: here
  std::filesystem::path log{};     // gets what it prints, on either stream
  double limit = 0.0;              // seconds until it is asked to end; 0: none
  double grace = 10.0;             // seconds from there until it is killed
  int kept = -1;                   // a descriptor that it keeps, such as that of a lock; -1: none
  std::stop_token stop{};          // asks it to end as well
};

struct ChildEnd {
  int exit_code = -1;  // -1: ended by `signal`
  int signal = 0;
  bool found = true;       // false: there is no such program
  bool timed_out = false;  // it was asked to end at the limit
  double seconds = 0.0;
};

// `program`: a path, or a name to be looked for in PATH; `arguments` without it. The child is asked
// to end by SIGTERM, also when this program dies, and has a process group of its own, so that
// Ctrl-C is for this program to pass on. Throws std::system_error when the system has no processes
// left, or the log cannot be written.
ChildEnd run_child(const std::string& program, const std::vector<std::string>& arguments,
                   const ChildOptions& options);

}  // namespace tencer::app::study
