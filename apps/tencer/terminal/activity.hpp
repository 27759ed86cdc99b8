// What a command does now, said again and again while it does it, so that nobody wonders whether it
// still does.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "terminal/console.hpp"

namespace tencer::app {

// While it lives: the words and the seconds since it began, in the console's line that is rewritten
// or, where there is none, as a log line every two seconds. Work of less than a second is not
// spoken of, and nothing is when the console is quiet.
class Activity {
 public:
  Activity(const Console& console, std::string words);
  ~Activity();
  Activity(const Activity&) = delete;
  Activity& operator=(const Activity&) = delete;

  // Any thread may tell.
  void now(std::string words);
  double seconds() const;  // since it began
  void end();              // nothing more is said; likewise at the end of its life

 private:
  std::string line();
  void tell(const std::stop_token& over);

  const Console& console_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::condition_variable_any waiting_;
  std::string words_;
  std::jthread teller_;
};

}  // namespace tencer::app
