// What a design does when its cables are pulled and let go, as it is told and written.
#pragma once

#include <stop_token>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/io/file.hpp>
#include <tencer/model/design.hpp>
#include <tencer/model/schedule.hpp>
#include <vector>

namespace tencer::app {

struct Told {
  std::string words{};
  std::vector<io::NamedText> files{};  // poses.csv, view.html, pose-0000.obj and so on
  bool finished = false;               // false: no rest was found before the end
};

// The design's units are known. Errors: it does not rest in its pose.
core::Expected<Told> actuate(const model::Design& design, const model::Schedule& schedule,
                             const std::stop_token& stop);

}  // namespace tencer::app
