// The poses that a design rests in, as files.
#pragma once

#include <tencer/io/file.hpp>
#include <tencer/rehearsal/rests.hpp>
#include <vector>

namespace tencer::app {

// What a folder of them holds: rests.json, report.txt, rest-1.json, rest-1.obj and so on, and
// view.html, which plays the ways. The design's units are known.
std::vector<io::NamedText> rests_files(const rehearsal::DesignRests& found);

}  // namespace tencer::app
