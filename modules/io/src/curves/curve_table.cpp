#include "curves/curve_table.hpp"

#include <algorithm>

#include "curves/finish_curve.hpp"
#include "text/bad_input.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

// Strictly at commas or semicolons when there are any, so that an empty field is seen.
std::vector<std::string_view> fields_of(std::string_view line) {
  const std::size_t found = line.find_first_of(",;");
  if (found == std::string_view::npos) return words(line);
  std::vector<std::string_view> fields;
  const char separator = line[found];
  for (std::size_t at = 0;;) {
    const std::size_t end = std::min(line.find(separator, at), line.size());
    const auto inside = words(line.substr(at, end - at));
    fields.push_back(inside.empty()      ? std::string_view()
                     : inside.size() > 1 ? line.substr(at, end - at)
                                         : inside[0]);
    if (end == line.size()) return fields;
    at = end + 1;
  }
}

Eigen::Vector3d parse_row(const std::vector<std::string_view>& fields, const std::string& where) {
  if (fields.size() != 3)
    fail(where, "expected 3 numbers x, y, z, found " + std::to_string(fields.size()) +
                    (fields.size() == 1 ? " field" : " fields"));
  return {coordinate(fields[0], where), coordinate(fields[1], where), coordinate(fields[2], where)};
}

}  // namespace

std::vector<geometry::Polyline> parse_table(std::string_view text, const std::string& file) {
  std::vector<geometry::Polyline> curves;
  ListedCurve curve;
  std::vector<int> rows;  // line of each point
  curve.where_of = [&](int i) { return file + ":" + std::to_string(rows[i]); };
  curve.name_of = [&](int i) { return "the point in line " + std::to_string(rows[i]); };
  const auto finish = [&] {
    if (rows.empty()) return;
    curve.where = curve.where_of(0);
    curves.push_back(finish_curve(curve));
    curve.points.clear();
    rows.clear();
  };

  int number = 0;
  bool first = true;
  for (const std::string_view line : lines(text)) {
    ++number;
    const std::size_t comment = line.find('#');
    const std::vector<std::string_view> fields = fields_of(line.substr(0, comment));
    if (fields.empty()) {
      if (comment == std::string_view::npos) finish();
      continue;
    }
    const bool header = first && std::ranges::none_of(fields, [](std::string_view field) {
                          return to_number(field).has_value();
                        });
    first = false;
    if (header) continue;
    rows.push_back(number);
    curve.points.push_back(parse_row(fields, file + ":" + std::to_string(number)));
  }
  finish();
  if (curves.empty()) fail(file, "the file holds no points; expected lines of 3 numbers x, y, z");
  return curves;
}

}  // namespace tencer::io
