// The sheet's tables as CSV: every row names its design, every number its unit.
#include <array>
#include <tencer/core/names.hpp>
#include <tencer/io/csv.hpp>

#include "fabricate/sheet.hpp"

namespace tencer::app {
namespace {

using core::cable_name;
using core::rod_name;
using io::CsvRow;
using io::to_text;

std::string table(const CsvRow& titles, const std::vector<CsvRow>& rows) {
  std::string text = io::csv_line(titles);
  for (const CsvRow& row : rows) text += io::csv_line(row);
  return text;
}

std::string optional_number(const std::optional<double>& number) {
  return number ? to_text(*number) : std::string();
}

std::string rods_table(const Sheet& sheet) {
  std::vector<CsvRow> rows;
  for (std::size_t r = 0; r < sheet.list.rods.size(); ++r) {
    const fabricate::RodCut& rod = sheet.list.rods[r];
    rows.push_back({sheet.title, rod_name(static_cast<int>(r)), rod.closed ? "true" : "false",
                    to_text(rod.length), to_text(rod.cut), to_text(rod.radius),
                    optional_number(rod.mass), to_text(rod.joint),
                    optional_number(rod.nearest_mark)});
  }
  return table({"design", "rod", "closed", "length_mm", "cut_mm", "outer_radius_mm", "mass_kg",
                "joint_s_mm", "nearest_mark_to_joint_mm"},
               rows);
}

std::string marks_table(const Sheet& sheet) {
  std::vector<CsvRow> rows;
  for (std::size_t r = 0; r < sheet.list.rods.size(); ++r) {
    const fabricate::RodCut& rod = sheet.list.rods[r];
    for (const model::Mark& mark : rod.marks)
      rows.push_back({sheet.title, rod_name(static_cast<int>(r)), to_text(mark.s),
                      to_text(rod.from_end(mark.s)), cable_name(mark.cable),
                      mark.end == 0 ? "from" : "to"});
  }
  return table({"design", "rod", "s_mm", "from_end_mm", "cable", "end"}, rows);
}

// The rod or anchor, and the place on the rod.
std::array<std::string, 2> end_cells(const springs::End& end) {
  if (const auto* anchor = std::get_if<springs::AtAnchor>(&end))
    return {core::anchor_name(anchor->anchor), ""};
  const auto& on = std::get<springs::OnRod>(end);
  return {rod_name(on.rod), to_text(on.s)};
}

std::string cables_table(const Sheet& sheet) {
  const std::vector<int> order = sheet.order.cables();
  std::vector<int> step(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) step[order[i]] = static_cast<int>(i) + 1;
  std::vector<CsvRow> rows;
  for (std::size_t c = 0; c < sheet.list.cables.size(); ++c) {
    const fabricate::CableCut& cable = sheet.list.cables[c];
    const auto [from, from_s] = end_cells(cable.a);
    const auto [to, to_s] = end_cells(cable.b);
    rows.push_back({sheet.title, cable_name(static_cast<int>(c)), from, from_s, to, to_s,
                    to_text(cable.tension), to_text(cable.between_centres),
                    to_text(cable.between_knots), to_text(cable.cut), std::to_string(step[c])});
  }
  return table({"design", "cable", "from", "from_s_mm", "to", "to_s_mm", "tension_N",
                "between_centres_mm", "between_knots_mm", "cut_mm", "tying_step"},
               rows);
}

std::string anchors_table(const Sheet& sheet) {
  std::vector<CsvRow> rows;
  const Eigen::Matrix3Xd& anchors = sheet.solid.anchors;
  for (int a = 0; a < anchors.cols(); ++a)
    rows.push_back({sheet.title, core::anchor_name(a), to_text(anchors(0, a)),
                    to_text(anchors(1, a)), to_text(anchors(2, a))});
  return table({"design", "anchor", "x_mm", "y_mm", "z_mm"}, rows);
}

// Rows of the pieces of rods or cables, bar by bar; without bars, one after the other.
void add_pieces(const Sheet& sheet, const fabricate::Purchase& purchase,
                const std::string& material, std::string (*name)(int), std::vector<CsvRow>& rows) {
  const auto add = [&](int p, const std::string& bar) {
    const fabricate::Piece& piece = purchase.pieces[p];
    rows.push_back(
        {sheet.title, material, bar, name(piece.of), to_text(piece.from), to_text(piece.length)});
  };
  if (!purchase.packing) {
    for (std::size_t p = 0; p < purchase.pieces.size(); ++p) add(static_cast<int>(p), "");
    return;
  }
  for (std::size_t b = 0; b < purchase.packing->bars.size(); ++b)
    for (const int p : purchase.packing->bars[b]) add(p, std::to_string(b + 1));
}

std::string pieces_table(const Sheet& sheet) {
  std::vector<CsvRow> rows;
  add_pieces(sheet, sheet.rods, "rod", rod_name, rows);
  add_pieces(sheet, sheet.cables, "cable", cable_name, rows);
  return table({"design", "material", "bar_or_coil", "of", "from_mm", "cut_mm"}, rows);
}

}  // namespace

std::vector<io::NamedText> sheet_tables(const Sheet& sheet) {
  return {{"rods.csv", rods_table(sheet)},
          {"marks.csv", marks_table(sheet)},
          {"cables.csv", cables_table(sheet)},
          {"anchors.csv", anchors_table(sheet)},
          {"pieces.csv", pieces_table(sheet)}};
}

}  // namespace tencer::app
