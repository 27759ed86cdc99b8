#include "fabricate/strips.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tencer/core/names.hpp>
#include <tencer/core/words.hpp>
#include <tencer/fabricate/names.hpp>

namespace tencer::app {
namespace {

using fabricate::RodCut;
using fabricate::tenths;

constexpr double height = 17;         // of a strip
constexpr double first_number = 8.9;  // base lines of the marks' numbers, from the upper edge
constexpr double number_step = 3.4;
constexpr int number_lines = 3;
constexpr Font mark_font{.size = 3.0, .bold = true, .colour = accent};

// Part of a rod, its upper left corner on paper.
struct Part {
  double from = 0.0;
  double to = 0.0;
  double x = 0.0;
  double y = 0.0;

  double on_paper(double s) const { return x + s - from; }
};

// Marks of several cables at one place, "3, 7".
struct Place {
  double at = 0.0;  // from the end of the rod
  std::string words{};
};

std::vector<Place> places_of(const RodCut& rod) {
  constexpr double same = 0.05;
  std::vector<Place> places;
  for (const model::Mark& mark : rod.marks) {
    const std::string name = core::cable_name(mark.cable);
    const double at = rod.from_end(mark.s);
    if (!places.empty() && at - places.back().at < same)
      places.back().words += ", " + name;
    else
      places.push_back({at, name});
  }
  return places;
}

void draw_ruler(Canvas& canvas, const Part& part) {
  constexpr double longest = 20000;  // with a tick each mm: files stay small enough to be opened
  const long step = part.to - part.from > longest ? 10 : 1;
  for (auto mm = static_cast<long>(std::ceil(part.from / static_cast<double>(step))) * step;
       mm <= static_cast<long>(part.to); mm += step) {
    const double x = part.on_paper(static_cast<double>(mm));
    const double tick = mm % 10 == 0 ? 2.8 : mm % 5 == 0 ? 2.0 : 1.2;
    canvas.line(x, part.y, x, part.y + tick, {soft_ink, mm % 10 == 0 ? 0.15 : 0.08});
    // Not over the edges.
    if (mm % 50 == 0 && static_cast<double>(mm) > part.from &&
        static_cast<double>(mm) + 5 < part.to)
      canvas.text(x, part.y + 5.2, std::to_string(mm), {2.1, false, soft_ink, Align::centre});
  }
}

void draw_marks(Canvas& canvas, const Part& part, const std::vector<Place>& places) {
  std::array<double, number_lines> free_from{};
  free_from.fill(part.x);
  for (const Place& place : places) {
    if (place.at < part.from || place.at > part.to) continue;
    const double x = part.on_paper(place.at);
    canvas.line(x, part.y, x, part.y + height, {accent, 0.18});
    // The first line on which there is room, else the one that is free soonest.
    auto line = std::ranges::find_if(free_from, [&](double free) { return free <= x; });
    if (line == free_from.end()) line = std::ranges::min_element(free_from);
    const double wide = canvas.width_of(place.words, mark_font);
    // Left of the mark where the strip ends.
    const bool beyond = x + wide + 1 > part.on_paper(part.to);
    Font font = mark_font;
    font.align = beyond ? Align::right : Align::left;
    canvas.text(x + (beyond ? -0.7 : 0.7),
                part.y + first_number + number_step * static_cast<double>(line - free_from.begin()),
                place.words, font);
    *line = x + (beyond ? 1 : wide + 1.6);
  }
}

// Where a strip is glued over another, or a rod's end over its start.
void draw_overlap(Canvas& canvas, const Part& part, double from) {
  constexpr double step = 2;
  for (double x = part.on_paper(from) + step; x < part.on_paper(part.to); x += step)
    canvas.line(x, part.y, x - step, part.y + height, {hairline, 0.1});
  canvas.line(part.on_paper(from), part.y, part.on_paper(from), part.y + height,
              {soft_ink, 0.15, true});
}

void draw_strip(Canvas& canvas, const Part& part, const RodCut& rod,
                const std::vector<Place>& places) {
  const double ends = std::min(part.to, rod.length);
  if (rod.length < part.to) draw_overlap(canvas, part, rod.length);
  draw_ruler(canvas, part);
  canvas.frame(part.x, part.y, part.to - part.from, height, {ink, 0.15});
  for (const double end : {0.0, rod.length})
    if (end >= part.from && end <= ends)
      canvas.line(part.on_paper(end), part.y, part.on_paper(end), part.y + height, {ink, 0.4});
  draw_marks(canvas, part, places);
}

// 100 mm, with a tick each ten.
void draw_check(Canvas& canvas, double x, double y) {
  canvas.line(x, y, x + 100, y, {ink, 0.3});
  for (int mm = 0; mm <= 100; mm += 10)
    canvas.line(x + mm, y - (mm % 50 == 0 ? 2.5 : 1.5), x + mm, y, {ink, 0.2});
  canvas.text(x + 104, y, "This line is 100 mm long when printed at 100 %.", {2.4, false, ink});
}

}  // namespace

std::string strip_svg(const fabricate::CutList& list, int rod) {
  constexpr double margin = 10;
  const RodCut& cut = list.rods[rod];
  const std::string title = "rod " + core::rod_name(rod) + ", " + tenths(cut.length) + " mm, 1 : 1";
  return svg_drawing(cut.cut + 2 * margin, height + 2 * margin, title, [&](Canvas& canvas) {
    canvas.text(margin, margin - 3, title, {3, false, soft_ink});
    draw_strip(canvas, {0, cut.cut, margin, margin}, cut, places_of(cut));
  });
}

void add_strips(Book& book, const fabricate::CutList& list) {
  constexpr double overlap = 10;
  constexpr double row = height + 8;
  constexpr double check_height = 10;
  const double step = std::floor((book.width() - overlap) / 10) * 10;
  book.section("Strips at 1 : 1");
  book.paragraph(
      "Print these pages at 100 %, not to fit the page, and measure the line at the foot of each. "
      "Cut the strips out and glue each one over "
      "the "
      "hatched end of the one before, its left edge on the dashed line; lay them along the rod "
      "from the end that it begins with, its start or its joint, and copy the marks. The numbers "
      "are "
      "those of the cables; the small ones are mm from that end.");
  bool ruled = false;
  for (std::size_t r = 0; r < list.rods.size(); ++r) {
    const RodCut& rod = list.rods[r];
    const auto places = places_of(rod);
    const int count = std::max(1, static_cast<int>(std::ceil((rod.cut - overlap) / step)));
    for (int i = 0; i < count; ++i) {
      if (book.y() + row + check_height > book.bottom()) {
        book.need(book.bottom());
        ruled = false;
      }
      if (!ruled) draw_check(book.canvas(), book.left(), book.bottom() - 1);
      ruled = true;
      const bool last = i + 1 == count;
      const Part part{.from = i * step,
                      .to = last ? rod.cut : (i + 1) * step + overlap,
                      .x = book.left(),
                      .y = book.y() + 5};
      const std::string name = core::rod_name(static_cast<int>(r));
      book.canvas().text(book.left(), book.y() + 3.8,
                         "rod " + name + "  ·  strip " + std::to_string(i + 1) + " of " +
                             std::to_string(count) + "  ·  " + tenths(part.from) + " to " +
                             tenths(part.to) + " mm",
                         {2.5, false, soft_ink});
      if (!last) draw_overlap(book.canvas(), part, (i + 1) * step);
      draw_strip(book.canvas(), part, rod, places);
      book.skip(row);
    }
  }
}

}  // namespace tencer::app
