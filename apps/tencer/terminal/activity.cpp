#include "terminal/activity.hpp"

#include <iomanip>
#include <sstream>
#include <utility>

namespace tencer::app {

using namespace std::chrono_literals;

Activity::Activity(const Console& console, std::string words)
    : console_(console), words_(std::move(words)) {
  if (!console.quiet()) teller_ = std::jthread([this](const std::stop_token& over) { tell(over); });
}

Activity::~Activity() { end(); }

void Activity::end() {
  teller_ = {};
  console_.show("");
}

void Activity::now(std::string words) {
  const std::lock_guard lock(mutex_);
  words_ = std::move(words);
}

double Activity::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

std::string Activity::line() {
  std::ostringstream text;
  text << words_ << "; " << std::fixed << std::setprecision(seconds() < 10 ? 1 : 0) << seconds()
       << " s";
  return text.str();
}

void Activity::tell(const std::stop_token& over) {
  const auto pause = console_.rewrites() ? 200ms : 1900ms;  // less than two seconds, also late
  std::unique_lock lock(mutex_);
  const auto over_after = [&](std::chrono::milliseconds time) {
    return waiting_.wait_for(lock, over, time, [&] { return over.stop_requested(); });
  };
  for (bool ends = over_after(1000ms); !ends; ends = over_after(pause)) {
    if (console_.rewrites())
      console_.show(line());
    else
      console_.log()(core::Level::info, "  " + line());
  }
}

}  // namespace tencer::app
