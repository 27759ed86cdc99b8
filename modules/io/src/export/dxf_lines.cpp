#include "export/dxf_lines.hpp"

#include <map>

#include "curves/dxf_units.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

class Dxf {
 public:
  void add(int code, std::string_view value) {
    text_.append(std::to_string(code)).append(1, '\n').append(value).append(1, '\n');
  }
  void add(int code, int value) { add(code, std::to_string(value)); }
  void add(const Eigen::Vector3d& point) {
    for (int i = 0; i < 3; ++i) add(10 * (i + 1), to_text(point[i]));
  }
  void begin_section(std::string_view name) {
    add(0, "SECTION");
    add(2, name);
  }
  void begin_table(std::string_view name, std::size_t entries) {
    add(0, "TABLE");
    add(2, name);
    add(70, static_cast<int>(entries));
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

void add_header(Dxf& dxf, std::string_view unit) {
  dxf.begin_section("HEADER");
  dxf.add(9, "$ACADVER");
  dxf.add(1, "AC1009");
  if (const auto number = dxf_number(unit)) {
    dxf.add(9, "$INSUNITS");
    dxf.add(70, *number);
  }
  dxf.add(0, "ENDSEC");
}

void add_tables(Dxf& dxf, std::span<const DxfLine> lines) {
  std::map<std::string, int> layers;
  for (const DxfLine& line : lines) layers.emplace(line.layer, line.colour);
  dxf.begin_section("TABLES");
  dxf.begin_table("LTYPE", 1);
  dxf.add(0, "LTYPE");
  dxf.add(2, "CONTINUOUS");
  dxf.add(70, 0);
  dxf.add(3, "Solid line");
  dxf.add(72, 65);
  dxf.add(73, 0);
  dxf.add(40, "0");
  dxf.add(0, "ENDTAB");
  dxf.begin_table("LAYER", layers.size());
  for (const auto& [layer, colour] : layers) {
    dxf.add(0, "LAYER");
    dxf.add(2, layer);
    dxf.add(70, 0);
    dxf.add(62, colour);
    dxf.add(6, "CONTINUOUS");
  }
  dxf.add(0, "ENDTAB");
  dxf.add(0, "ENDSEC");
}

void add_polyline(Dxf& dxf, const DxfLine& line) {
  constexpr int closed = 1;
  constexpr int in_space = 8;
  constexpr int vertex_in_space = 32;
  dxf.add(0, "POLYLINE");
  dxf.add(8, line.layer);
  dxf.add(66, 1);  // vertices follow
  dxf.add(Eigen::Vector3d::Zero());
  dxf.add(70, in_space + (line.line.closed ? closed : 0));
  for (const auto& point : line.line.points.colwise()) {
    dxf.add(0, "VERTEX");
    dxf.add(8, line.layer);
    dxf.add(point);
    dxf.add(70, vertex_in_space);
  }
  dxf.add(0, "SEQEND");
  dxf.add(8, line.layer);
}

}  // namespace

std::string dxf_text(std::span<const DxfLine> lines, std::string_view unit) {
  Dxf dxf;
  add_header(dxf, unit);
  add_tables(dxf, lines);
  dxf.begin_section("ENTITIES");
  for (const DxfLine& line : lines) {
    if (line.line.vertices() > 1) {
      add_polyline(dxf, line);
      continue;
    }
    dxf.add(0, "POINT");
    dxf.add(8, line.layer);
    dxf.add(line.line.points.col(0));
  }
  dxf.add(0, "ENDSEC");
  dxf.add(0, "EOF");
  return dxf.take();
}

}  // namespace tencer::io
