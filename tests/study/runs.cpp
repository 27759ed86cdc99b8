// Which runs a study has, and what becomes of programs it starts.
#include "study/runs.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <thread>

#include "study/child.hpp"
#include "study/folder_lock.hpp"

using namespace tencer::app::study;
namespace fs = std::filesystem;

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

TEST_CASE("one study at a time in a folder") {
  const Folder folder;
  {
    const FolderLock first(folder.path);
    CHECK_FALSE(first.problem());
    const FolderLock second(folder.path);
    REQUIRE(second.problem());
    CHECK(second.problem()->where == folder.path.string());
  }
  CHECK_FALSE(FolderLock(folder.path).problem());
  CHECK(FolderLock(folder.path / "none").problem());
}
