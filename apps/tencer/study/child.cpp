#include "child.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>

namespace tencer::app::study {
namespace {

constexpr int not_found = 127;  // as shells have it

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

// A file descriptor that is closed in the end, and in children.
class Descriptor {
 public:
  Descriptor(int number, const std::string& what) : number_(number) {
    if (number < 0) fail(what);
  }
  ~Descriptor() { ::close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

// Becomes the program. After fork in a program with threads: nothing here may allocate or lock.
[[noreturn]] void become(char* const* arguments, const char* folder, int log, int kept) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  sigset_t none;
  sigemptyset(&none);
  pthread_sigmask(SIG_SETMASK, &none, nullptr);
  if (kept >= 0) fcntl(kept, F_SETFD, 0);
  const bool ready = dup2(log, STDOUT_FILENO) >= 0 && dup2(log, STDERR_FILENO) >= 0 &&
                     (*folder == '\0' || chdir(folder) == 0);
  if (ready) execvp(arguments[0], arguments);
  _exit(not_found);
}

}  // namespace

ChildEnd run_child(const std::string& program, const std::vector<std::string>& arguments,
                   const ChildOptions& options) {
  using Clock = std::chrono::steady_clock;
  const auto seconds_since = [](Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  };
  std::vector<std::string> all{program};
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (auto& argument : all) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  const std::string folder = options.folder.string();
  const Descriptor log(::open(options.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666),
                       options.log.string());

  const auto begin = Clock::now();
  const pid_t child = fork();
  if (child < 0) fail("fork");
  if (child == 0) become(pointers.data(), folder.c_str(), log.number(), options.kept);

  ChildEnd end;
  int status = 0;
  bool asked = false;
  double asked_at = 0.0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    // Short against any run, and no load.
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    const double now = seconds_since(begin);
    const bool late = options.limit > 0 && now > options.limit;
    if (!asked && (late || options.stop.stop_requested())) {
      asked = true;
      asked_at = now;
      end.timed_out = late;
      kill(child, SIGTERM);
    } else if (asked && now > asked_at + options.grace) {
      kill(child, SIGKILL);
    }
  }
  end.seconds = seconds_since(begin);
  if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  end.found = end.exit_code != not_found;
  return end;
}

}  // namespace tencer::app::study
