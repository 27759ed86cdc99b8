#include "curves/curve_table.hpp"

#include <algorithm>
#include <tencer/model/units.hpp>

#include "curves/finish_curve.hpp"
#include "text/bad_input.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// A comma between two digits: 3,25.
bool has_decimal_comma(std::string_view field) {
  const std::size_t comma = field.find(',');
  return comma != std::string_view::npos && comma > 0 && comma + 1 < field.size() &&
         is_digit(field[comma - 1]) && is_digit(field[comma + 1]) &&
         field.find(',', comma + 1) == std::string_view::npos;
}

// Strictly at this separator, so that an empty field is seen.
std::vector<std::string_view> separated(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
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

// At semicolons or commas when there are any, else at blanks; commas may be decimal where they need
// not separate.
std::vector<std::string_view> fields_of(std::string_view line) {
  if (line.find(';') != std::string_view::npos) return separated(line, ';');
  std::vector<std::string_view> fields = words(line);
  if (line.find(',') == std::string_view::npos) return fields;
  const bool decimal =
      fields.size() == 3 && std::ranges::any_of(fields, has_decimal_comma) &&
      std::ranges::all_of(fields, [](std::string_view field) {
        return field.find(',') == std::string_view::npos || has_decimal_comma(field);
      });
  return decimal ? fields : separated(line, ',');
}

double parse_field(std::string_view field, const std::string& where) {
  if (!has_decimal_comma(field)) return coordinate(field, where);
  std::string with_point(field);
  with_point[with_point.find(',')] = '.';
  return coordinate(with_point, where);
}

// What lines that are not three numbers are likely to be.
std::string remedy(const std::vector<std::string_view>& fields) {
  const auto number = [&](std::size_t i) { return to_number(fields[i]).has_value(); };
  if (fields.size() == 2 && number(0) && number(1))
    return "; a flat curve needs a z too: add a third column of zeros";
  if (fields.size() == 1 && to_integer(fields[0]))
    return "; of an XYZ file of atoms drop the count, the line after it and the elements, so that "
           "three numbers are left on each line";
  if (fields.size() == 4 && !number(0) && number(1) && number(2) && number(3))
    return "; drop the word before the three numbers of each line";
  return {};
}

Eigen::Vector3d parse_row(const std::vector<std::string_view>& fields, const std::string& where) {
  if (fields.size() != 3)
    fail(where, "expected 3 numbers x, y, z, found " + std::to_string(fields.size()) +
                    (fields.size() == 1 ? " field" : " fields") + remedy(fields));
  return {parse_field(fields[0], where), parse_field(fields[1], where),
          parse_field(fields[2], where)};
}

// The length unit that a header or comment names: "x (mm)", "[mm]", "unit: mm".
std::optional<std::string> unit_in(std::string_view line) {
  std::string text(line);
  for (char& c : text)
    if (std::string_view("()[]{},;:=\"#").find(c) != std::string_view::npos) c = ' ';
  const std::vector<std::string_view> parts = words(text);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const bool after_name = parts[i - 1] == "unit" || parts[i - 1] == "units" ||
                            parts[i - 1] == "Unit" || parts[i - 1] == "Units" ||
                            parts[i - 1].size() == 1;
    if (after_name &&
        std::ranges::find(model::length_units(), parts[i]) != model::length_units().end())
      return std::string(parts[i]);
  }
  return std::nullopt;
}

}  // namespace

CurveFile parse_table(std::string_view text, const std::string& file) {
  CurveFile result;
  ListedCurve curve;
  std::vector<int> rows;  // line of each point
  curve.where_of = [&](int i) { return file + ":" + std::to_string(rows[i]); };
  curve.name_of = [&](int i) { return "the point in line " + std::to_string(rows[i]); };
  const auto finish = [&] {
    if (rows.empty()) return;
    curve.where = curve.where_of(0);
    result.curves.push_back(finish_curve(curve, result.notes));
    curve.points.clear();
    rows.clear();
  };

  int number = 0;
  bool first = true;
  for (const std::string_view line : lines(text)) {
    ++number;
    const std::size_t comment = line.find('#');
    if (rows.empty() && result.curves.empty() && !result.length_unit)
      result.length_unit = unit_in(line);
    const std::vector<std::string_view> fields = fields_of(line.substr(0, comment));
    if (fields.empty()) {
      if (comment == std::string_view::npos) finish();
      continue;
    }
    const bool header = first && std::ranges::none_of(fields, [](std::string_view field) {
                          return to_number(field) || has_decimal_comma(field);
                        });
    first = false;
    if (header) continue;
    rows.push_back(number);
    curve.points.push_back(parse_row(fields, file + ":" + std::to_string(number)));
  }
  finish();
  if (result.curves.empty())
    fail(file, "the file holds no points; expected lines of 3 numbers x, y, z");
  return result;
}

}  // namespace tencer::io
