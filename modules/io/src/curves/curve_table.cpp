#include "curves/curve_table.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "curves/finish_curve.hpp"
#include "text/bad_input.hpp"
#include "text/length_unit.hpp"
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

// Without blanks and quotes around it.
std::string_view trimmed(std::string_view field) {
  const std::size_t first = field.find_first_not_of(" \t\r\v\f");
  if (first == std::string_view::npos) return {};
  field = field.substr(first, field.find_last_not_of(" \t\r\v\f") + 1 - first);
  if (field.size() > 1 && field.front() == '"' && field.back() == '"')
    return trimmed(field.substr(1, field.size() - 2));
  return field;
}

// Strictly at this separator, so that an empty field is seen.
std::vector<std::string_view> separated(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  for (std::size_t at = 0;;) {
    const std::size_t end = std::min(line.find(separator, at), line.size());
    fields.push_back(trimmed(line.substr(at, end - at)));
    if (end == line.size()) return fields;
    at = end + 1;
  }
}

// At semicolons or commas when there are any, else at blanks; commas may be decimal where they need
// not separate.
std::vector<std::string_view> fields_of(std::string_view line) {
  if (line.find(';') != std::string_view::npos) return separated(line, ';');
  std::vector<std::string_view> fields = words(line);
  if (line.find(',') == std::string_view::npos) {
    std::ranges::transform(fields, fields.begin(), trimmed);
    return fields;
  }
  const bool decimal =
      (fields.size() == 2 || fields.size() == 3) &&
      std::ranges::any_of(fields, has_decimal_comma) &&
      std::ranges::all_of(fields, [](std::string_view field) {
        return field.find(',') == std::string_view::npos || has_decimal_comma(field);
      });
  return decimal ? fields : separated(line, ',');
}

bool is_number(std::string_view field) { return to_number(field) || has_decimal_comma(field); }

double parse_field(std::string_view field, const std::string& where) {
  if (!has_decimal_comma(field)) return coordinate(field, where);
  std::string with_point(field);
  with_point[with_point.find(',')] = '.';
  return coordinate(with_point, where);
}

// The line up to a comment. A semicolon separates, so it starts none.
std::string_view without_comment(std::string_view line) {
  const std::string_view content = line.substr(0, line.find('#'));
  const auto first = content.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  const std::string_view rest = content.substr(first);
  return rest.starts_with('%') || rest.starts_with("//") ? std::string_view() : content;
}

// Which fields of a row are x, y and z; z is -1 in a plane.
struct Columns {
  int count = 3;  // of fields
  std::array<int, 3> of{0, 1, 2};
};

// "X (mm)", "x_coord", "Points:0"; -1: none of them.
int axis_of(std::string_view name) {
  if (name == "Points:0" || name == "Points_0") return 0;
  if (name == "Points:1" || name == "Points_1") return 1;
  if (name == "Points:2" || name == "Points_2") return 2;
  if (name.empty()) return -1;
  const auto letter = std::string_view("xyz").find(
      static_cast<char>(std::tolower(static_cast<unsigned char>(name[0]))));
  const bool alone = name.size() == 1 || !std::isalnum(static_cast<unsigned char>(name[1]));
  return letter != std::string_view::npos && alone ? static_cast<int>(letter) : -1;
}

// Of the names in a header; not set where x and y are not among them.
std::optional<Columns> named_columns(const std::vector<std::string_view>& names) {
  Columns columns{static_cast<int>(names.size()), {-1, -1, -1}};
  for (int i = 0; i < columns.count; ++i)
    if (const int axis = axis_of(names[i]); axis >= 0 && columns.of[axis] < 0) columns.of[axis] = i;
  if (columns.of[0] < 0 || columns.of[1] < 0) return std::nullopt;
  return columns;
}

// What rows of a wrong number of fields are likely to be.
std::string remedy(const std::vector<std::string_view>& fields) {
  const auto number = [&](std::size_t i) { return to_number(fields[i]).has_value(); };
  if (fields.size() == 1 && to_integer(fields[0]))
    return "; of an XYZ file of atoms drop the count, the line after it and the elements, so that "
           "three numbers are left on each line";
  if (fields.size() == 4 && !number(0) && number(1) && number(2) && number(3))
    return "; drop the word before the three numbers of each line";
  if (fields.size() == 6 && std::ranges::all_of(fields, is_number))
    return "; where commas are decimal, separate the numbers by semicolons";
  if (fields.size() > 3 && std::ranges::all_of(fields, is_number))
    return "; name the columns in a first line, such as x, y, z, others";
  return {};
}

[[noreturn]] void fail_count(const std::vector<std::string_view>& fields, const std::string& what,
                             const std::string& where) {
  fail(where, "expected " + what + ", found " + std::to_string(fields.size()) +
                  (fields.size() == 1 ? " field" : " fields") + remedy(fields));
}

class TableReader {
 public:
  explicit TableReader(const std::string& file) : file_(file) {
    curve_.where_of = [this](int i) { return file_ + ":" + std::to_string(rows_[i]); };
    curve_.name_of = [this](int i) { return "the point in line " + std::to_string(rows_[i]); };
  }
  TableReader(const TableReader&) = delete;
  TableReader& operator=(const TableReader&) = delete;

  CurveFile read(std::string_view text) {
    std::optional<std::string_view> unit;
    int number = 0;
    for (const std::string_view line : lines(text)) {
      ++number;
      if (begun_ == 0 && !unit) unit = unit_in(line);
      const std::string_view content = without_comment(line);
      if (!words(content).empty())
        add(fields_of(content), number);
      else if (words(line).empty())
        finish();
    }
    finish();
    if (result_.curves.empty())
      fail(file_, "the file holds no points; expected lines of 3 numbers x, y, z");
    if (unit) result_.length_unit = *unit;
    return std::move(result_);
  }

 private:
  void add(const std::vector<std::string_view>& fields, int number) {
    const std::string where = file_ + ":" + std::to_string(number);
    if (!columns_ && std::ranges::none_of(fields, is_number) && !header_) {
      header_ = true;
      columns_ = named_columns(fields);
      return;
    }
    if (!columns_) columns_ = columns_of(fields, where);
    if (static_cast<int>(fields.size()) != columns_->count)
      fail_count(
          fields,
          columns_->count == 3 ? "3 numbers x, y, z" : std::to_string(columns_->count) + " fields",
          where);
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    for (int axis = 0; axis < 3; ++axis)
      if (columns_->of[axis] >= 0) point[axis] = parse_field(fields[columns_->of[axis]], where);
    curve_.points.push_back(point);
    rows_.push_back(number);
    ++begun_;
  }

  // Of a table without names, by its first row.
  Columns columns_of(const std::vector<std::string_view>& fields, const std::string& where) {
    if (fields.size() == 2 && std::ranges::all_of(fields, is_number)) {
      result_.notes.push_back(where + ": two numbers a line: z is taken as 0");
      return {2, {0, 1, -1}};
    }
    if (fields.size() != 3) fail_count(fields, "3 numbers x, y, z", where);
    return {};
  }

  void finish() {
    if (rows_.empty()) return;
    curve_.where = curve_.where_of(0);
    finish_curve(curve_, result_);
    curve_.points.clear();
    rows_.clear();
  }

  const std::string& file_;
  CurveFile result_;
  ListedCurve curve_;
  std::vector<int> rows_;  // line of each point
  std::optional<Columns> columns_;
  bool header_ = false;
  int begun_ = 0;  // points so far
};

}  // namespace

CurveFile parse_table(std::string_view text, const std::string& file) {
  return TableReader(file).read(text);
}

}  // namespace tencer::io
