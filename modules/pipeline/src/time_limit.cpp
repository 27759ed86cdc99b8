#include "time_limit.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace tencer::pipeline {

TimeLimit::TimeLimit(std::optional<double> seconds, const std::stop_token& stop)
    : forward_(stop, [this] { source_.request_stop(); }) {
  if (!seconds) return;
  timer_ = std::jthread(
      [this, time = std::chrono::duration<double>(*seconds)](const std::stop_token& over) {
        std::mutex mutex;
        std::condition_variable_any sleeping;
        std::unique_lock lock(mutex);
        sleeping.wait_for(lock, over, time, [] { return false; });
        if (!over.stop_requested()) source_.request_stop();
      });
}

}  // namespace tencer::pipeline
