// What to cut of rod and where to mark it, and what to thread before it is joined.
#include <algorithm>
#include <numbers>
#include <tencer/core/names.hpp>
#include <tencer/core/words.hpp>
#include <tencer/fabricate/names.hpp>

#include "fabricate/sheet.hpp"
#include "fabricate/words.hpp"

namespace tencer::app {
namespace {

using fabricate::tenths;

std::string joint_words(const fabricate::RodCut& rod, double joint) {
  std::string text = "Cut " + tenths(rod.cut) + " mm";
  if (!rod.closed) return text + ". The rod is open: mark 0 is its start.";
  text += joint > 0 ? ": " + tenths(rod.length) + " mm and " + tenths(joint) +
                          " mm by which its ends overlap (--joint)"
                    : "; its ends meet, in a sleeve (0 mm of overlap; --joint gives another)";
  text += rod.joint > 0 ? ". The joint is at " + tenths(rod.joint) +
                              " mm, where marks leave most room: there the piece begins"
                        : ". The joint is at the start";
  if (!rod.nearest_mark) return text + '.';
  text += "; the nearest mark is " + tenths(*rod.nearest_mark) + " mm from it";
  return text + (*rod.nearest_mark < joint ? ", within the overlap." : ".");
}

// How the ends of a closed rod are turned against each other.
std::string twist_words(const der::Rod& rod) {
  if (!rod.closing_angle)
    return "Let the ends turn in the joint until the last cable is tied, then glue them.";
  return "Its ends are held against turning where they meet: closing angle " +
         significant(*rod.closing_angle * 180 / std::numbers::pi) + " degrees.";
}

// Where the piece does not begin at the start, with the place on it first.
std::vector<Cells> mark_rows(const Sheet& sheet, const fabricate::RodCut& rod) {
  std::vector<Cells> rows;
  for (const model::Mark& mark : rod.marks) {
    const fabricate::CableCut& cable = sheet.list.cables[mark.cable];
    rows.push_back({tenths(mark.s), core::cable_name(mark.cable), mark.end == 0 ? "from" : "to",
                    fabricate::end_name(mark.end == 0 ? cable.b : cable.a)});
    if (rod.joint > 0) rows.back().insert(rows.back().begin(), tenths(rod.from_end(mark.s)));
  }
  return rows;
}

void add_marks(Book& book, const Sheet& sheet, const fabricate::RodCut& rod) {
  std::vector<Column> columns{
      {"s mm"}, {"cable", Align::right, true}, {"end", Align::left}, {"goes to", Align::left}};
  if (rod.joint > 0) columns.insert(columns.begin(), {"from the end mm"});
  book.table(columns, mark_rows(sheet, rod));
}

std::string pair_words(const fabricate::ThreadedPair& pair) {
  const std::string a = core::rod_name(pair.a);
  const std::string b = core::rod_name(pair.b);
  if (pair.linking_number == 0)
    return "Rods " + a + " and " + b +
           ": linking number 0, but one lies within the other or goes through it, or others hold "
           "them together. Lay both as drawn before either is joined.";
  return "Rods " + a + " and " + b + " are linked (linking number " +
         std::to_string(std::abs(pair.linking_number)) + "): thread rod " + b + " through rod " +
         a + " before the ends of " + b + " are joined.";
}

// Of closed rods: afterwards it is too late.
void add_threading(Book& book, const Sheet& sheet) {
  if (std::ranges::none_of(sheet.list.rods, &fabricate::RodCut::closed)) return;
  book.heading("Before the ends are joined");
  std::vector<std::string> words;
  for (std::size_t r = 0; r < sheet.list.rods.size(); ++r)
    if (sheet.threading.knotted[r]) {
      const std::string name = core::rod_name(static_cast<int>(r));
      words.push_back("Rod " + name + " is a knot: lay it as drawn before its ends are joined.");
    }
  for (const fabricate::ThreadedPair& pair : sheet.threading.pairs)
    words.push_back(pair_words(pair));
  for (const std::string& line : words) book.paragraph(line);
  if (words.empty())
    book.paragraph("No closed rod is found to be a knot, and none goes through another.");
  book.paragraph(
      "Found by the linking numbers of the rods and planes between them, and by the Alexander "
      "polynomial, which tells every knot of fewer than eleven crossings from a ring. The views "
      "from three sides show where one passes over the other.",
      {2.7, false, soft_ink});
}

}  // namespace

void add_rods(Book& book, const Sheet& sheet) {
  book.section("Rods");
  book.paragraph(
      "Marks are measured from the start along the straight rod, in mm; strips of paper to copy "
      "them from are at the end and, in one piece each, in strip-A.svg and so on. Every mark is "
      "one end of a cable, which goes from there to the place in the last column.");
  add_threading(book, sheet);
  for (std::size_t r = 0; r < sheet.list.rods.size(); ++r) {
    const fabricate::RodCut& rod = sheet.list.rods[r];
    const der::Rod& model_rod = sheet.design.structure.rods[r];
    book.heading("Rod " + core::rod_name(static_cast<int>(r)) +
                 (rod.closed ? ", closed" : ", open"));
    book.paragraph(joint_words(rod, sheet.list.allowances.joint));
    if (rod.closed) book.paragraph(twist_words(model_rod));
    if (model_rod.rest_curvature.size() > 0)
      book.paragraph("It is bent already when nothing holds it: measure along its centre line.");
    if (rod.marks.empty())
      book.paragraph("No cable is tied to it.");
    else
      add_marks(book, sheet, rod);
  }
}

}  // namespace tencer::app
