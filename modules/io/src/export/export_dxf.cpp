#include <algorithm>
#include <cctype>

#include "export/dxf_lines.hpp"
#include "export/parts.hpp"
#include "export/writers.hpp"

namespace tencer::io {
namespace {

// Names of layers have no blanks and no small letters in release 12.
std::string layer_name(std::string name) {
  std::ranges::transform(name, name.begin(), [](unsigned char c) {
    return c == ' ' ? '_' : static_cast<char>(std::toupper(c));
  });
  return name;
}

int colour_of(PartKind kind) {
  constexpr int blue = 5;
  constexpr int red = 1;
  constexpr int grey = 8;
  return kind == PartKind::rod ? blue : kind == PartKind::cable ? red : grey;
}

}  // namespace

// A layer a part: "ROD_A", "CABLE_1".
std::string dxf_parts(const model::Design& design) {
  std::vector<DxfLine> lines;
  for (Part& part : parts_of(design))
    lines.push_back({layer_name(part.name), colour_of(part.kind), std::move(part.line)});
  return dxf_text(lines, design.length_unit);
}

}  // namespace tencer::io
