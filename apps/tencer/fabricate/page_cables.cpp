// What to cut of cable, in which order to tie it, and labels for the pieces.
#include <tencer/core/names.hpp>
#include <tencer/core/words.hpp>
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

// What tying the cable does, in a few words; none while the rods are held.
std::string step_words(const TyingOrder& order, std::size_t i) {
  if (i < order.held.size()) return order.rehearsed ? "rods held in shape" : "";
  const TyingStep& step = order.steps[i - order.held.size()];
  return "moves " + tenths(step.moved_mm) + " mm, pulls " + significant(step.tension_n) + " N" +
         (step.parts > 1 ? ", " + std::to_string(step.parts) + " parts before" : "");
}

void draw_step(Book& book, const Sheet& sheet, const Seen& seen, std::size_t i, const Look& look,
               const Eigen::Vector2d& corner, const Tile& tile) {
  constexpr double words_height = 14.5;
  const int c = look.new_cable;
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
  book.canvas().text(corner.x(), y + 10, step_words(sheet.order, i), {2.5, false, soft_ink});
}

std::string names_of(const std::vector<int>& cables) {
  std::vector<std::string> names;
  for (const int c : cables) names.push_back(cable_name(c));
  return core::listed(names);
}

// How far the order is known to go well.
std::string order_words(const TyingOrder& order) {
  const std::string red = " In each picture the new cable is red.";
  if (!order.rehearsed)
    return "A suggestion: from the first mark of rod A on, always the cable nearest along the rods "
           "to "
           "one that is tied. The design does not rest in its pose, so that nothing is known of "
           "the "
           "shapes on the way: hold the rods, or hang them up, until the last cable is tied." +
           red;
  std::string words =
      "Found by taking the finished structure apart in simulation, a cable at a time, each let go "
      "slowly. ";
  if (order.held.empty())
    return words +
           "It stands by itself from the first cable on: tie one after the other. What a step "
           "moves, "
           "and the pull that it ends with, are below its picture." +
           red;
  const auto count = static_cast<int>(order.held.size());
  if (order.steps.empty())
    words +=
        "There is no order in which it stands before all cables are tied: hold the rods in shape, "
        "or hang them up, until the last one is. ";
  else
    words +=
        "First tie " + core::counted(count, "cable") + " (" + names_of(order.held) +
        ") while the rods are held in shape, taped to a drawing or hung up. Then let go: it "
        "stands, and the others follow one after the other. What a step moves, and the pull that "
        "it ends with, are below its picture. ";
  const std::string falls = " it would fall, or could not be followed. ";
  if (order.would_fall.empty())
    words += "Without any one of these strands would touch.";
  else if (order.would_fall.size() == order.held.size())
    words += "Without any one of these" + falls;
  else
    words += "Without " + names_of(order.would_fall) + falls +
             "Without any other of these strands would touch.";
  return words + red;
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
  const std::vector<int> order = sheet.order.cables();
  if (order.empty()) return;
  book.section("Order of tying");
  book.paragraph(order_words(sheet.order));
  constexpr double gap = 6;
  const Seen seen(sheet.solid, oblique_axes(points_of(sheet.solid)));
  const Tile tile{(book.width() - 2 * gap) / 3, 59.5};
  Look look{.rod_width = 0.55,
            .cable_width = 0.2,
            .starts = false,
            .rod_names = false,
            .anchor_names = false,
            .plain = true,
            .tied = std::vector<bool>(order.size(), false)};
  double y = book.y();
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i % 3 == 0) {
      book.need(tile.height);
      y = book.y();
      book.skip(tile.height);
    }
    look.new_cable = order[i];
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
