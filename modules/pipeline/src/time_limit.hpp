// Ends what runs after a time.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <thread>

namespace tencer::pipeline {

// Its token is told to stop after so many seconds, if any, or when `stop` is.
class TimeLimit {
 public:
  TimeLimit(std::optional<double> seconds, const std::stop_token& stop);

  std::stop_token token() const { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::stop_callback<std::function<void()>> forward_;
  std::jthread timer_;  // not running without a time
};

}  // namespace tencer::pipeline
