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
    latest_ = Progress{std::string(progress.stage), progress.cables, progress.max_percent,
                       progress.seconds};
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
    while (!done_) {
      news_.wait_for(lock, patience, [&] { return done_ || latest_; });
      const std::optional<Progress> latest = std::exchange(latest_, std::nullopt);
      lock.unlock();
      {
        const py::gil_scoped_acquire held;
        look(latest);
      }
      lock.lock();
    }
  }
  if (thrown) std::rethrow_exception(thrown);
  if (raised_) throw std::move(*raised_);
}

void LongCall::look(const std::optional<Progress>& latest) {
  if (PyErr_CheckSignals() != 0) take(py::error_already_set());
  if (!latest || raised_) return;
  try {
    const py::object answer = told_(*latest);
    if (!answer.is_none() && answer.cast<bool>()) stop_.request_stop();
  } catch (py::error_already_set& error) {
    take(error);
  }
}

// Ctrl-C may also come while Python's function runs.
void LongCall::take(const py::error_already_set& error) {
  const bool by_key = error.matches(PyExc_KeyboardInterrupt);
  if (!by_key || ++interrupts_ > 1) raised_.emplace(error);
  stop_.request_stop();
}

}  // namespace tencer::python
