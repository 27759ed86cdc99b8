#include <algorithm>

#include "export/parts.hpp"
#include "export/writers.hpp"
#include "text/text.hpp"

namespace tencer::io {

// An `o` a part: lines for rods and cables, points for anchors. Some readers end a name at a blank.
std::string obj_parts(const model::Design& design) {
  std::string text = "# tencer, lengths in " + design.length_unit + "\n";
  int first = 1;
  for (const Part& part : parts_of(design)) {
    std::string name = part.name;
    std::ranges::replace(name, ' ', '_');
    text += "o " + name + "\n";
    const int n = part.line.vertices();
    for (const auto& point : part.line.points.colwise()) {
      text += 'v';
      for (const double coordinate : point) text.append(1, ' ').append(to_text(coordinate));
      text += '\n';
    }
    text += part.kind == PartKind::anchor ? 'p' : 'l';
    for (int i = 0; i < n + (part.line.closed ? 1 : 0); ++i)
      text.append(1, ' ').append(std::to_string(first + i % n));
    text += '\n';
    first += n;
  }
  return text;
}

}  // namespace tencer::io
