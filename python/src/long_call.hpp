// Calls that may take long: the interpreter is free meanwhile, Ctrl-C asks them to stop, and
// progress is told in the thread that called.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <tencer/core/log.hpp>
#include <tencer/network/stage.hpp>
#include <utility>
#include <vector>

#include "bind.hpp"

namespace tencer::python {

// Progress that outlives its telling.
struct Progress {
  std::string stage{};
  int cables = 0;
  double max_percent = 0.0;
  double seconds = 0.0;
};

class LongCall {
 public:
  // told: called with the latest Progress, never with two at a time; one that returns something
  // true asks to stop. None: nobody is told.
  explicit LongCall(py::object told) : told_(std::move(told)) {}

  std::stop_token token() const { return stop_.get_token(); }
  network::ProgressSink sink();
  core::Log log();  // to Python's warnings, and what is no warning to the logger "tencer"

  // Does `work` in a thread of its own and waits for it. Throws what it throws; or what `told`
  // raised, once the work has stopped; or KeyboardInterrupt when Ctrl-C came twice. `work` must not
  // touch Python.
  void run(const std::function<void()>& work);

 private:
  // What came up since the last look.
  struct News {
    std::optional<Progress> latest{};
    std::vector<std::pair<core::Level, std::string>> said{};
  };
  void look(const News& news);
  void say(core::Level level, const std::string& text);
  void take(const py::error_already_set& error);

  py::object told_;
  std::stop_source stop_;
  std::mutex mutex_;
  std::condition_variable news_;
  News fresh_;
  bool done_ = false;
  int interrupts_ = 0;
  std::optional<py::error_already_set> raised_;
};

// work(call), and what it returns.
template <class Work>
auto long_call(py::object told, Work&& work) {
  LongCall call(std::move(told));
  std::optional<decltype(work(call))> result;
  call.run([&] { result.emplace(work(call)); });
  return std::move(*result);
}

}  // namespace tencer::python
