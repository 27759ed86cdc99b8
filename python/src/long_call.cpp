#include "long_call.hpp"

#include <chrono>
#include <exception>
#include <thread>
#include <utility>

namespace tencer::python {

network::ProgressSink LongCall::sink() {
  if (told_.is_none()) return {};
  return [this](const network::Progress& progress) {
    const std::lock_guard lock(mutex_);
    fresh_.latest = Progress{std::string(progress.stage), progress.cables, progress.max_percent,
                             progress.seconds};
    news_.notify_one();
  };
}

core::Log LongCall::log() {
  return [this](core::Level level, std::string_view text) {
    if (level == core::Level::debug) return;
    const std::lock_guard lock(mutex_);
    fresh_.said.emplace_back(level, text);
    news_.notify_one();
  };
}

void LongCall::run(const std::function<void()>& work) {
  constexpr std::chrono::milliseconds patience(50);  // between two looks at signals
  std::exception_ptr thrown;
  {
    const py::gil_scoped_release free;
    std::jthread worker([&] {
      try {
        work();
      } catch (...) {
        thrown = std::current_exception();
      }
      const std::lock_guard lock(mutex_);
      done_ = true;
      news_.notify_one();
    });
    std::unique_lock lock(mutex_);
    for (bool over = false; !over;) {
      news_.wait_for(lock, patience,
                     [&] { return done_ || fresh_.latest || !fresh_.said.empty(); });
      over = done_;  // what was said before is told yet
      const News news = std::exchange(fresh_, News{});
      lock.unlock();
      {
        const py::gil_scoped_acquire held;
        look(news);
      }
      lock.lock();
    }
  }
  if (thrown) std::rethrow_exception(thrown);
  if (raised_) throw std::move(*raised_);
}

void LongCall::look(const News& news) {
  if (PyErr_CheckSignals() != 0) take(py::error_already_set());
  if (raised_) return;
  try {
    for (const auto& [level, text] : news.said) say(level, text);
    if (!news.latest || told_.is_none()) return;
    const py::object answer = told_(*news.latest);
    if (!answer.is_none() && answer.cast<bool>()) stop_.request_stop();
  } catch (py::error_already_set& error) {
    take(error);
  }
}

void LongCall::say(core::Level level, const std::string& text) {
  if (level == core::Level::warning) {
    if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), 1) != 0) throw py::error_already_set();
    return;
  }
  py::module_::import("logging").attr("getLogger")("tencer").attr("info")(text);
}

// Ctrl-C may also come while Python's function runs.
void LongCall::take(const py::error_already_set& error) {
  const bool by_key = error.matches(PyExc_KeyboardInterrupt);
  if (!by_key || ++interrupts_ > 1) raised_.emplace(error);
  stop_.request_stop();
}

}  // namespace tencer::python
