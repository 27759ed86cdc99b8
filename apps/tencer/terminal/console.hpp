// The terminal as commands see it: what they find goes to stdout; log lines go to stderr, and below
// them, while work goes on, one line that is rewritten.
#pragma once

#include <functional>
#include <string>
#include <tencer/core/log.hpp>

namespace tencer::app {

// May be used by several threads at once.
class Console {
 public:
  // Shows messages of this level and above; with `warning` nothing is said but these.
  explicit Console(core::Level least);

  const core::Log& log() const { return log_; }

  // Words about a result, on stdout; not when quiet. What is asked for as data (--json) is no
  // words.
  void say(const std::string& text) const;

  bool quiet() const { return least_ == core::Level::warning; }

  // Whether stderr is a terminal whose last line can be rewritten.
  bool rewrites() const { return rewrites_; }

  // Puts `status` in that line, cut to the terminal's width; empty: takes the line away.
  void show(const std::string& status) const { show_(status); }

 private:
  core::Level least_;
  bool rewrites_;
  core::Log log_;
  std::function<void(const std::string&)> show_;
};

}  // namespace tencer::app
