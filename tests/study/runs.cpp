// Which runs a study has, and what becomes of programs it starts.
#include "study/runs.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <thread>

#include "study/child.hpp"
#include "study/file_lock.hpp"
#include "study/records.hpp"
#include "study/submit.hpp"

using namespace tencer::app::study;
namespace fs = std::filesystem;
using Catch::Matchers::Contains;

namespace {

// An empty folder, gone in the end.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("tencer-study-" + std::to_string(::getpid()));
  Folder() { fs::create_directory(path); }
  ~Folder() { fs::remove_all(path); }
  std::string text(const char* name) const {
    std::ifstream file(path / name);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
};

}  // namespace

TEST_CASE("runs are all combinations that make sense") {
  const auto runs = runs_of({.scenes = {"a/one.toml", "two.obj"},
                             .methods = {"force-balance", "dense-springs"},
                             .force_balance = {"gauss-newton"},
                             .dense_springs = {"ipopt", "mma"},
                             .resolutions = {0.5, 1}});
  REQUIRE(runs);
  CHECK(runs->size() == 2 * (1 + 2) * 2);
  CHECK(title_of(runs->front()) == "one, force-balance, gauss-newton, x0.5");
  CHECK(folder_of(runs->back()) == "two-dense-springs-mma-x1");
  CHECK(runs->front().file == "a/one.toml");

  const auto errors = runs_of({.scenes = {"one.toml"},
                               .methods = {"force-balance"},
                               .force_balance = {"mma"},
                               .resolutions = {1},
                               .max_errors = {0.5, 2}});
  REQUIRE(errors);
  REQUIRE(errors->size() == 2);
  CHECK(title_of(errors->front()) == "one, force-balance, mma, x1, max error 0.5 %");
  CHECK(folder_of(errors->front()) == "one-force-balance-mma-x1-0.5percent");
  CHECK_FALSE(same_run(errors->front(), errors->back()));

  const auto twice = runs_of({.scenes = {"a/one.toml", "b/one.obj"}});
  REQUIRE_FALSE(twice);
  CHECK(twice.error().where == "b/one.obj");
}

TEST_CASE("a program's exit code and output are kept") {
  const Folder folder;
  const auto end = run_child("sh", {"-c", "pwd; echo trouble >&2; exit 3"},
                             {.folder = folder.path, .log = folder.path / "log"});
  CHECK(end.exit_code == 3);
  CHECK(end.signal == 0);
  CHECK(end.found);
  CHECK_FALSE(end.timed_out);
  CHECK(end.seconds > 0);
  CHECK(folder.text("log") == fs::canonical(folder.path).string() + "\ntrouble\n");
}

TEST_CASE("a program that crashes, or is not there, is told from one that ends") {
  const Folder folder;
  const auto crashed = run_child("sh", {"-c", "kill -SEGV $$"}, {.log = folder.path / "log"});
  CHECK(crashed.exit_code == -1);
  CHECK(crashed.signal == SIGSEGV);
  CHECK(crashed.found);
  CHECK_FALSE(run_child("no-such-program", {}, {.log = folder.path / "log"}).found);
  CHECK_THROWS_AS(run_child("true", {}, {.log = folder.path / "none/log"}), std::system_error);
}

TEST_CASE("at its limit a program is asked to end, and killed when it does not") {
  const Folder folder;
  const auto asked = run_child("sh", {"-c", "trap 'exit 3' TERM; while :; do sleep 0.01; done"},
                               {.log = folder.path / "log", .limit = 0.2});
  CHECK(asked.timed_out);
  CHECK(asked.exit_code == 3);
  const auto killed = run_child("sh", {"-c", "trap '' TERM; while :; do sleep 0.01; done"},
                                {.log = folder.path / "log", .limit = 0.2, .grace = 0.1});
  CHECK(killed.timed_out);
  CHECK(killed.signal == SIGKILL);
}

TEST_CASE("a request to stop reaches the program") {
  const Folder folder;
  std::stop_source stop;
  std::jthread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    stop.request_stop();
  });
  const auto end =
      run_child("sleep", {"600"}, {.log = folder.path / "log", .stop = stop.get_token()});
  CHECK(end.signal == SIGTERM);
  CHECK_FALSE(end.timed_out);
}

TEST_CASE("one program at a time holds a file, until its child ends too") {
  const Folder folder;
  const fs::path file = folder.path / "lock";
  {
    const auto first = FileLock::at_once(file);
    REQUIRE(first);
    CHECK(first->has_value());
    const auto second = FileLock::at_once(file);
    REQUIRE(second);
    CHECK_FALSE(second->has_value());
  }
  // A child that outlives the program which started it.
  const pid_t parent = fork();
  if (parent == 0) {
    const auto lock = FileLock::at_once(file);
    run_child("sh", {"-c", "trap '' TERM; echo > started; exec sleep 0.5"},
              {.folder = folder.path, .log = folder.path / "log", .kept = (*lock)->descriptor()});
    _exit(0);
  }
  while (!fs::exists(folder.path / "started"))
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  const auto held = FileLock::at_once(file);
  REQUIRE(held);
  CHECK_FALSE(held->has_value());
  CHECK(FileLock::in_turn(file));  // waits for the child

  CHECK_FALSE(FileLock::at_once(folder.path / "none/lock"));
  CHECK_FALSE(FileLock::in_turn(folder.path / "none/lock"));
}

TEST_CASE("a run is made once, and recorded") {
  const Folder folder;
  const Run run{.scene = "knot", .file = "knot.obj", .method = "m", .optimizer = "o"};
  fs::create_directory(folder.path / "runs");
  CHECK_FALSE(recorded(run, folder.path)->has_value());
  CHECK(all_records(folder.path)->empty());

  // Another program is at it.
  {
    const auto lock = FileLock::at_once(log_of(folder.path, run));
    const auto attempt = make(run, folder.path, {});
    REQUIRE(attempt);
    CHECK(attempt->fate == Attempt::Fate::elsewhere);
    CHECK_FALSE(attempt->row);
  }
  CHECK_FALSE(record({.run = run, .status = "complete", .seconds = 2}, folder.path));
  const auto known = make(run, folder.path, {});
  REQUIRE(known);
  CHECK(known->fate == Attempt::Fate::known);
  CHECK(known->row->seconds == 2);

  // In order of their names, whoever was first.
  Run other = run;
  other.scene = "arch";
  CHECK_FALSE(record({.run = other, .status = "failed"}, folder.path));
  const auto all = all_records(folder.path);
  REQUIRE(all);
  REQUIRE(all->size() == 2);
  CHECK(all->front().run.scene == "arch");

  other = run;
  other.file = "elsewhere/knot.obj";
  CHECK(make(other, folder.path, {}).error().where == "elsewhere/knot.obj");

  // What a crash of the machine left is no record.
  std::ofstream(record_of(folder.path, run), std::ios::trunc).flush();
  CHECK_FALSE(recorded(run, folder.path)->has_value());
  CHECK(all_records(folder.path)->size() == 1);
}

TEST_CASE("scripts make every run once, whatever is in names") {
  Submission submission{.here = "/home/o'hara/my study",
                        .program = "/usr/bin/tencer",
                        .options = {"--output", "out"},
                        .scenes = {"a knot.obj", "b.obj"},
                        .folder = "out",
                        .runs = 2500,
                        .threads = 2,
                        .time_limit = 60};
  const std::string slurm = slurm_script(submission);
  CHECK_THAT(slurm, Contains("#SBATCH --array=1-1000\n"));
  CHECK_THAT(slurm, Contains("#SBATCH --cpus-per-task=2\n"));
  CHECK_THAT(slurm, Contains("#SBATCH --time=9\n"));  // three runs of a minute, and their checks
  CHECK_THAT(slurm, Contains("cd '/home/o'\\''hara/my study' || exit\n"));
  CHECK_THAT(slurm, Contains("run <= 2500; run += 1000"));
  CHECK_THAT(slurm,
             Contains("/usr/bin/tencer study --output out --run $run -- 'a knot.obj' b.obj"));
  submission.runs = 3;
  CHECK_THAT(slurm_script(submission), Contains("#SBATCH --array=1-3\n"));
  const std::string parallel = parallel_script(submission);
  CHECK_THAT(parallel, Contains("seq 3 | parallel "));
  CHECK_THAT(parallel, Contains("/usr/bin/tencer study --output out --collect\n"));
}
