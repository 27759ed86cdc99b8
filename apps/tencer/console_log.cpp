#include "console_log.hpp"

#include <spdlog/logger.h>
#include <spdlog/sinks/stdout_sinks.h>

#include <memory>

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

}  // namespace

core::Log console_log(core::Level least) {
  const auto logger =
      std::make_shared<spdlog::logger>("tencer", std::make_shared<spdlog::sinks::stderr_sink_mt>());
  logger->set_pattern("%v");
  logger->set_level(spdlog_level(least));
  return [logger](core::Level level, std::string_view message) {
    const char* prefix = level == core::Level::warning ? "warning: " : "";
    logger->log(spdlog_level(level), "{}{}", prefix, message);
  };
}

}  // namespace tencer::app
