// Where the structure is held in space, and what hangs on it.
#include <tencer/core/names.hpp>
#include <tencer/fabricate/names.hpp>
#include <tencer/model/units.hpp>

#include "fabricate/sheet.hpp"
#include "fabricate/three_views.hpp"
#include "fabricate/words.hpp"

namespace tencer::app {
namespace {

using core::rod_name;
using fabricate::tenths;

// Cables that end at the anchor.
std::string cables_at(const Sheet& sheet, int anchor) {
  std::string names;
  for (std::size_t c = 0; c < sheet.list.cables.size(); ++c)
    for (const springs::End& end : {sheet.list.cables[c].a, sheet.list.cables[c].b})
      if (const auto* at = std::get_if<springs::AtAnchor>(&end); at && at->anchor == anchor)
        names += (names.empty() ? "" : ", ") + core::cable_name(static_cast<int>(c));
  return names.empty() ? "none" : names;
}

Cells with_place(Cells cells, const Eigen::Vector3d& place) {
  for (const double coordinate : place) cells.push_back(tenths(coordinate));
  return cells;
}

void add_anchors(Book& book, const Sheet& sheet) {
  const Eigen::Matrix3Xd& anchors = sheet.solid.anchors;
  if (anchors.cols() == 0) return;
  book.heading("Anchors");
  std::vector<Cells> rows;
  for (int a = 0; a < anchors.cols(); ++a) {
    rows.push_back(with_place({core::anchor_name(a)}, anchors.col(a)));
    rows.back().push_back(cables_at(sheet, a));
  }
  book.table({{"", Align::left, true}, {"x mm"}, {"y mm"}, {"z mm"}, {"cables", Align::left}},
             rows);
}

void add_pins(Book& book, const Sheet& sheet) {
  const model::Structure& structure = sheet.design.structure;
  if (structure.pins.empty()) return;
  const double mm = 1000 * model::metres(sheet.design.length_unit);
  const auto along = model::arc_lengths(structure);
  book.heading("Places where rods are held");
  std::vector<Cells> rows;
  for (const model::Pin& pin : structure.pins) {
    std::string axes;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (pin.axes[axis]) axes += (axes.empty() ? "" : ", ") + std::string(1, "xyz"[axis]);
    rows.push_back(
        with_place({rod_name(pin.rod), tenths(along[pin.rod].knots()[pin.vertex] * mm), axes},
                   sheet.design.pose[pin.rod].col(pin.vertex) * mm));
  }
  book.table({{"rod", Align::left, true},
              {"s mm"},
              {"held in", Align::left},
              {"x mm"},
              {"y mm"},
              {"z mm"}},
             rows);
}

void add_loads(Book& book, const Sheet& sheet) {
  const model::Structure& structure = sheet.design.structure;
  if (structure.point_loads.empty() && structure.line_loads.empty()) return;
  const double metre = model::metres(sheet.design.length_unit);
  const double newton = model::newtons(sheet.design.force_unit);
  const auto row = [](Cells cells, const Eigen::Vector3d& force) {
    for (const double part : force) cells.push_back(significant(part));
    return cells;
  };
  book.heading("Loads");
  std::vector<Cells> rows;
  for (const model::PointLoad& load : structure.point_loads)
    rows.push_back(
        row({rod_name(load.rod), tenths(1000 * metre * load.s), "N"}, newton * load.force));
  for (const model::LineLoad& load : structure.line_loads)
    rows.push_back(
        row({rod_name(load.rod), "all along", "N/m"}, newton / metre * load.force_per_length));
  book.table({{"rod", Align::left, true}, {"s mm"}, {"", Align::left}, {"x"}, {"y"}, {"z"}}, rows);
}

}  // namespace

void add_supports(Book& book, const Sheet& sheet) {
  const model::Structure& structure = sheet.design.structure;
  const bool held = sheet.solid.anchors.cols() > 0 || !structure.pins.empty();
  if (!held && structure.point_loads.empty() && structure.line_loads.empty()) return;
  book.section("Anchors and loads");
  book.paragraph("Coordinates are those of the design, in mm.");
  add_anchors(book, sheet);
  add_pins(book, sheet);
  add_loads(book, sheet);
  if (!held) return;
  book.heading("Where it is held");
  Eigen::Matrix3d axes;
  if (structure.planar)
    axes.setIdentity();
  else
    axes << 1, 0, 0, 0, 0, 1, 0, -1, 0;  // along y, z upwards
  draw_three_views(book, sheet.solid, axes, {.rod_width = 0.8, .cable_width = 0.2, .plain = true},
                   0.45 * book.height(),
                   structure.planar
                       ? std::array<std::string, 3>{"x to the right, y up", "", ""}
                       : std::array<std::string, 3>{"x to the right, z up", "x to the right, y up",
                                                    "y to the right, z up"});
}

}  // namespace tencer::app
