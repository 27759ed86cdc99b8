#include "terminal/console.hpp"

#include <spdlog/logger.h>
#include <spdlog/sinks/base_sink.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <mutex>
#include <string_view>

namespace tencer::app {
namespace {

spdlog::level::level_enum spdlog_level(core::Level level) {
  switch (level) {
    case core::Level::debug:
      return spdlog::level::debug;
    case core::Level::info:
      return spdlog::level::info;
    case core::Level::warning:
      break;
  }
  return spdlog::level::warn;
}

bool stderr_rewrites() {
  const char* kind = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && kind && std::string_view(kind) != "dumb";
}

std::size_t columns() {
  winsize size = {};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

// stderr, with the status as its last line.
class StatusSink final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  void show(const std::string& status) {
    const std::lock_guard lock(mutex_);
    if (status.empty() && status_.empty()) return;
    status_ = status;
    put(erase);
    paint();
  }

 protected:
  void sink_it_(const spdlog::details::log_msg& message) override {
    spdlog::memory_buf_t line;
    formatter_->format(message, line);
    if (!status_.empty()) put(erase);
    put({line.data(), line.size()});
    paint();
  }
  void flush_() override { std::fflush(stderr); }

 private:
  static constexpr std::string_view erase = "\r\x1b[K";

  static void put(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

  // A full line would make some terminals go on to the next.
  void paint() {
    put(std::string_view(status_).substr(0, columns() - 1));
    std::fflush(stderr);
  }

  std::string status_;
};

}  // namespace

Console::Console(core::Level least) : least_(least), rewrites_(stderr_rewrites()) {
  const auto sink = std::make_shared<StatusSink>();
  const auto logger = std::make_shared<spdlog::logger>("tencer", sink);
  logger->set_pattern("%v");
  logger->set_level(spdlog_level(least));
  log_ = [logger](core::Level level, std::string_view message) {
    const char* prefix = level == core::Level::warning ? "warning: " : "";
    logger->log(spdlog_level(level), "{}{}", prefix, message);
  };
  show_ = [sink](const std::string& status) { sink->show(status); };
}

void Console::say(const std::string& text) const {
  if (quiet()) return;
  show("");
  std::cout << text;
}

}  // namespace tencer::app
