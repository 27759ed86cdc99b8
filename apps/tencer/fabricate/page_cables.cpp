// What to cut of cable, in which order to tie it, and labels for the pieces.
#include <tencer/core/names.hpp>
#include <tencer/fabricate/names.hpp>

#include "drawing/axes.hpp"
#include "drawing/drawing.hpp"
#include "fabricate/sheet.hpp"
#include "fabricate/words.hpp"

namespace tencer::app {
namespace {

using core::cable_name;
using fabricate::end_name;
using fabricate::tenths;

std::vector<Cells> cable_rows(const fabricate::CutList& list) {
  std::vector<Cells> rows;
  for (std::size_t c = 0; c < list.cables.size(); ++c) {
    const fabricate::CableCut& cable = list.cables[c];
    rows.push_back({cable_name(static_cast<int>(c)), end_name(cable.a), end_name(cable.b),
                    significant(cable.tension), tenths(cable.between_centres),
                    tenths(cable.between_knots), tenths(cable.cut)});
  }
  return rows;
}

std::string slack_words(const fabricate::CutList& list) {
  std::string names;
  for (std::size_t c = 0; c < list.cables.size(); ++c)
    if (list.cables[c].tension <= 0)
      names += (names.empty() ? "" : ", ") + cable_name(static_cast<int>(c));
  return names.empty() ? names : "Slack, doing nothing: cable " + names + ".";
}

// The pictures of the steps lie in rows of three.
struct Tile {
  double width = 0.0;
  double height = 0.0;
};

void draw_step(Book& book, const Sheet& sheet, const Seen& seen, std::size_t i, const Look& look,
               const Eigen::Vector2d& corner, const Tile& tile) {
  constexpr double words_height = 11;
  const int c = sheet.order[i];
  const fabricate::CableCut& cable = sheet.list.cables[c];
  const Eigen::Vector2d room(tile.width, tile.height - words_height);
  const Eigen::Vector2d inside = room - Eigen::Vector2d(6, 6);
  const Eigen::Vector2d size = seen.box().sizes();
  const double scale = std::min(inside.x() / size.x(), inside.y() / size.y());
  draw(book.canvas(), seen, {corner + room / 2, scale, {corner, corner + room}}, look);
  const double y = corner.y() + room.y();
  book.canvas().text(corner.x(), y + 2.5, std::to_string(i + 1) + ".  cable " + cable_name(c),
                     {3, true});
  book.canvas().text(
      corner.x(), y + 6.5,
      end_name(cable.a) + " to " + end_name(cable.b) + ", " + tenths(cable.between_knots) + " mm",
      {2.5, false, soft_ink});
}

}  // namespace

void add_cables(Book& book, const Sheet& sheet) {
  const double knot = sheet.list.allowances.knot;
  book.section("Cables");
  if (sheet.list.cables.empty()) {
    book.paragraph("There are none.");
    return;
  }
  book.paragraph(
      "Between centres: the length in the design, from the centre line of one rod to that of the "
      "other. Between knots: what stays free, from surface to surface, for a cable is tied round "
      "the "
      "rod; the radius of the rod is taken off at each end on one (half its largest size where it "
      "is not round), nothing at an anchor, which counts as a point. Cut: between knots, and " +
      tenths(knot) +
      " mm at each end for what goes round the rod and into the knot (--knot gives another).");
  book.paragraph(
      "The length between knots is that under the tension given. Cables are taken not to stretch: "
      "of "
      "one that does, tie less by what it stretches under that tension.");
  if (const std::string slack = slack_words(sheet.list); !slack.empty())
    book.paragraph(slack, {3.1, true, accent});
  book.table({{"cable", Align::right, true},
              {"from mm", Align::left},
              {"to mm", Align::left},
              {"tension N"},
              {"between centres mm"},
              {"between knots mm"},
              {"cut mm", Align::right, true}},
             cable_rows(sheet.list));
  book.paragraph("In all " + tenths(sheet.list.cables_cut()) + " mm.");
}

void add_order(Book& book, const Sheet& sheet) {
  if (sheet.order.empty()) return;
  book.section("Order of tying");
  book.paragraph(
      "A suggestion: from the first mark of rod A on, always the cable nearest along the rods to "
      "one that is tied. Nothing is known of the shapes on the way, and they need not stand: hold "
      "the "
      "rods, or hang them up, until the last cable is tied. In each picture the new cable is red.");
  constexpr double gap = 6;
  const Seen seen(sheet.solid, oblique_axes(points_of(sheet.solid)));
  const Tile tile{(book.width() - 2 * gap) / 3, 56};
  Look look{.rod_width = 0.55,
            .cable_width = 0.2,
            .starts = false,
            .rod_names = false,
            .anchor_names = false,
            .plain = true,
            .tied = std::vector<bool>(sheet.order.size(), false)};
  double y = book.y();
  for (std::size_t i = 0; i < sheet.order.size(); ++i) {
    if (i % 3 == 0) {
      book.need(tile.height);
      y = book.y();
      book.skip(tile.height);
    }
    look.new_cable = sheet.order[i];
    look.tied[look.new_cable] = true;
    const Eigen::Vector2d corner(book.left() + static_cast<double>(i % 3) * (tile.width + gap), y);
    draw_step(book, sheet, seen, i, look, corner, tile);
  }
}

void add_labels(Book& book, const Sheet& sheet) {
  if (sheet.list.cables.empty()) return;
  constexpr double height = 17;
  book.section("Labels to cut out");
  const double width = book.width() / 3;
  double y = book.y();
  for (std::size_t c = 0; c < sheet.list.cables.size(); ++c) {
    const fabricate::CableCut& cable = sheet.list.cables[c];
    if (c % 3 == 0) {
      book.need(height);
      y = book.y();
      book.skip(height);
    }
    Canvas& canvas = book.canvas();
    const double x = book.left() + static_cast<double>(c % 3) * width;
    canvas.frame(x, y, width, height, {soft_ink, 0.12, true});
    const std::string name = cable_name(static_cast<int>(c));
    const Font number{8, true, accent};
    canvas.text(x + 3, y + 11.5, name, number);
    const double beside = x + 6 + std::max(10.0, canvas.width_of(name, number));
    canvas.text(beside, y + 5.3, end_name(cable.a) + " to " + end_name(cable.b), {2.6});
    canvas.text(beside, y + 9.3, "between knots " + tenths(cable.between_knots), {2.6});
    canvas.text(beside, y + 13.3, "cut " + tenths(cable.cut), {2.6, true});
  }
}

}  // namespace tencer::app
