#include "fabricate/book.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace tencer::app {
namespace {

constexpr double top = 18;
constexpr double line_height = 1.45;  // of the font's size
constexpr double row_height = 5.2;
constexpr Font cell_font{.size = 3.0};
constexpr double cell_gap = 5;    // between columns
constexpr double table_gap = 12;  // between tables side by side

// What all rows of a table need.
std::vector<double> column_widths(Canvas& canvas, const std::vector<Column>& columns,
                                  const std::vector<Cells>& rows) {
  std::vector<double> widths;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    double width = canvas.width_of(columns[c].title, {2.5, true});
    for (const Cells& row : rows)
      width = std::max(width, canvas.width_of(row[c], {cell_font.size, columns[c].bold}));
    widths.push_back(width);
  }
  return widths;
}

double total_width(const std::vector<double>& widths) {
  double total = cell_gap * static_cast<double>(widths.size() - 1);
  for (const double width : widths) total += width;
  return total;
}

// One row, its upper left corner at x, y.
void draw_row(Canvas& canvas, double x, double y, const std::vector<Column>& columns,
              const std::vector<double>& widths, const Cells& cells, bool head) {
  const double from = x;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    Font font = head ? Font{2.5, true, soft_ink} : cell_font;
    font.bold |= columns[c].bold;
    font.align = columns[c].align;
    const double at = font.align == Align::left    ? x
                      : font.align == Align::right ? x + widths[c]
                                                   : x + widths[c] / 2;
    canvas.text(at, y + row_height - 1.6, cells[c], font);
    x += widths[c] + cell_gap;
  }
  canvas.line(from, y + row_height, x - cell_gap, y + row_height,
              {head ? ink : hairline, head ? 0.25 : 0.12});
}

}  // namespace

Book::Book(const PaperSize& paper, std::string title, Contents known)
    : paper_(paper),
      title_(std::move(title)),
      known_(std::move(known)),
      pdf_(paper.width, paper.height, title_) {}

void Book::begin_page() {
  if (page_ > 0) pdf_.end_page();
  ++page_;
  y_ = top;
  const double foot = paper_.height - 11;
  const Font font{2.5, false, soft_ink};
  canvas().line(left(), foot - 4, right(), foot - 4, {hairline, 0.15});
  const std::string number =
      "page " + std::to_string(page_) + " of " + std::to_string(known_.pages);
  canvas().text(right(), foot, number, {2.5, false, soft_ink, Align::right});
  std::string words = title_;
  if (sections_.back().title != title_) words += "  ·  " + sections_.back().title;
  canvas().text(left(), foot, canvas().fitting(words, 0.8 * width(), font), font);
}

void Book::section(const std::string& title) {
  sections_.push_back({title, page_ + 1});
  begin_page();
  canvas().text(left(), y_ + 5, canvas().fitting(title, width(), {6, true}), {6, true});
  y_ += 12;
}

void Book::need(double height) {
  if (y_ + height > bottom()) begin_page();
}

void Book::heading(const std::string& words) {
  need(30);
  y_ += 4;
  canvas().text(left(), y_ + 4, canvas().fitting(words, width(), {4, true}), {4, true});
  y_ += 8;
}

void Book::paragraph(const std::string& words, const Font& font) {
  std::istringstream stream(words);
  std::string line;
  const auto put = [&] {
    need(line_height * font.size);
    canvas().text(left(), y_ + font.size, line, font);
    y_ += line_height * font.size;
  };
  for (std::string word; stream >> word;) {
    const std::string longer = line.empty() ? word : line + ' ' + word;
    if (!line.empty() && canvas().width_of(longer, font) > width()) {
      put();
      line = word;
    } else {
      line = longer;
    }
  }
  if (!line.empty()) put();
  y_ += 0.6 * font.size;
}

void Book::table(const std::vector<Column>& columns, const std::vector<Cells>& rows) {
  constexpr double fewest = 6;  // rows below each other
  const auto widths = column_widths(canvas(), columns, rows);
  const double wide = total_width(widths);
  const auto beside = std::max<std::size_t>(
      1, static_cast<std::size_t>((width() + table_gap) / (wide + table_gap)));
  Cells titles;
  for (const Column& column : columns) titles.push_back(column.title);
  for (std::size_t row = 0; row < rows.size();) {
    need((fewest + 1) * row_height);
    const auto fit = static_cast<std::size_t>((bottom() - y_) / row_height) - 1;
    const std::size_t left_over = rows.size() - row;
    const std::size_t even = (left_over + beside - 1) / beside;
    const std::size_t high =
        std::min({fit, left_over, std::max(even, static_cast<std::size_t>(fewest))});
    for (std::size_t column = 0; column < beside && row < rows.size(); ++column) {
      const double x = left() + static_cast<double>(column) * (wide + table_gap);
      draw_row(canvas(), x, y_, columns, widths, titles, true);
      for (std::size_t i = 0; i < high && row < rows.size(); ++i, ++row)
        draw_row(canvas(), x, y_ + static_cast<double>(i + 1) * row_height, columns, widths,
                 rows[row], false);
    }
    y_ += static_cast<double>(high + 1) * row_height;
    if (row < rows.size()) begin_page();
  }
  y_ += 3;
}

std::string Book::finish() {
  pdf_.end_page();
  return pdf_.finish();
}

}  // namespace tencer::app
