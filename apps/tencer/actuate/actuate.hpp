// What a design does when its cables are pulled and let go, as files.
#pragma once

#include <string>
#include <tencer/io/file.hpp>
#include <tencer/rehearsal/actuate.hpp>
#include <vector>

namespace tencer::app {

// The page, which plays the poses.
std::string view_page(const rehearsal::Actuated& actuated);

// What a folder of it holds: poses.csv, view.html, pose-0000.obj and so on. The design's units are
// known.
std::vector<io::NamedText> actuation_files(const rehearsal::Actuated& actuated);

}  // namespace tencer::app
