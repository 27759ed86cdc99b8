// The first pages: what it is, whether it was found fit to be built, and how it looks.
#include <algorithm>
#include <tencer/core/names.hpp>
#include <tencer/core/version.hpp>
#include <tencer/core/words.hpp>
#include <tencer/fabricate/names.hpp>
#include <tencer/model/units.hpp>
#include <tencer/model/words.hpp>

#include "drawing/axes.hpp"
#include "fabricate/sheet.hpp"
#include "fabricate/three_views.hpp"
#include "fabricate/words.hpp"

namespace tencer::app {
namespace {

using core::counted;
using fabricate::tenths;

struct Verdict {
  Colour colour = accent;
  std::string head{};
  std::vector<std::string> lines{};
};

std::string tolerance_words(const Sheet& sheet, const io::FiledCheck::Tolerance& tolerance) {
  const auto mm = [&](double length) {
    return significant(1000 * model::metres(sheet.design.length_unit) * length) + " mm";
  };
  return "Cables cut to " + mm(tolerance.length_error) + " and tied to " +
         mm(tolerance.attachment_error) + ": within " + mm(tolerance.percentile_95) +
         " of the drawing (95 of 100 built so).";
}

Verdict checked(const Sheet& sheet, const io::FiledCheck& check) {
  Verdict verdict;
  std::string missing;
  for (const std::string& section : not_looked_at(sheet))
    missing += (missing.empty() ? "" : ", ") + section;
  if (check.passed == false) {
    verdict.head = "Checked: it does not pass";
  } else if (missing.empty()) {
    verdict.head = "Checked: it passes";
    verdict.colour = good;
  } else {
    verdict.head = "Checked in part: nothing fails of what was looked at";
    verdict.colour = ink;
  }
  if (check.tolerance) verdict.lines.push_back(tolerance_words(sheet, *check.tolerance));
  for (const std::string& reason : check.fails) verdict.lines.push_back(reason + ".");
  if (!missing.empty())
    verdict.lines.push_back("Not looked at: " + missing +
                            ". tencer check DESIGN -o FOLDER does; make this sheet of the design "
                            "in FOLDER.");
  return verdict;
}

Verdict not_checked(const Sheet& sheet) {
  const auto& certificate = sheet.design.certificate;
  return {
      .head = "Not checked: nobody knows yet whether it can be built",
      .lines = {"Run tencer check DESIGN -o FOLDER, and make this sheet of the design in FOLDER.",
                !certificate          ? "Nothing says that it stands."
                : certificate->stable ? "In theory it stands as it is drawn."
                                      : "It does not stand as it is drawn."}};
}

// What the check found, or what is known without one.
Verdict verdict_of(const Sheet& sheet) {
  Verdict verdict = sheet.check ? checked(sheet, *sheet.check) : not_checked(sheet);
  if (sheet.design.status == model::DesignStatus::tolerance_not_reached)
    verdict.lines.emplace_back("The design falls short of what was asked for.");
  if (sheet.design.status == model::DesignStatus::interrupted)
    verdict.lines.emplace_back("The search was interrupted: this is the best design until then.");
  return verdict;
}

void add_verdict(Book& book, const Sheet& sheet) {
  const Verdict verdict = verdict_of(sheet);
  const double from = book.y();
  book.paragraph(verdict.head, {4, true, verdict.colour});
  book.skip(-1.5);
  for (const std::string& line : verdict.lines) book.paragraph(line);
  book.canvas().line(book.left() - 3, from, book.left() - 3, book.y() - 1, {verdict.colour, 0.8});
}

void add_drawing(Book& book, const Sheet& sheet) {
  const Seen seen(sheet.solid, oblique_axes(points_of(sheet.solid)));
  constexpr double margin = 9;
  // What follows fits below, unless there are many rods.
  const double facts = 68 + 5.2 * sheet.solid.rods;
  const double height = std::clamp(book.bottom() - book.y() - facts, 90.0, 145.0);
  book.need(height);
  const Eigen::Vector2d corner(book.left(), book.y());
  const Eigen::Vector2d room(book.width(), height);
  const double scale =
      usual_scale(seen.box().sizes(), room - Eigen::Vector2d(2 * margin, 2 * margin));
  draw(book.canvas(), seen, {corner + room / 2, scale, {corner, corner + room}}, {});
  draw_scale_bar(book.canvas(), book.right(), book.y() + height - 3, scale);
  book.skip(height + 2);
}

std::vector<Cells> rod_rows(const Sheet& sheet) {
  std::vector<Cells> rows;
  for (std::size_t r = 0; r < sheet.list.rods.size(); ++r) {
    const fabricate::RodCut& rod = sheet.list.rods[r];
    const auto& materials = sheet.design.structure.materials;
    const der::Shape& shape = sheet.design.structure.rods[r].section.shape;
    rows.push_back({core::rod_name(static_cast<int>(r)), rod.closed ? "closed" : "open",
                    tenths(rod.length), tenths(rod.cut),
                    model::in_words(shape, sheet.design.length_unit),
                    materials.empty() ? "not known" : model::in_words(materials[r]),
                    rod.mass ? model::mass_in_words(*rod.mass) : "not known"});
  }
  return rows;
}

std::string box_words(const Sheet& sheet) {
  Eigen::AlignedBox3d box;
  const Eigen::Matrix3d axes = principal_axes(points_of(sheet.solid));
  for (int r = 0; r < sheet.solid.rods; ++r)
    for (const auto& point : sheet.solid.curves[r].points.colwise()) {
      const Eigen::Vector3d seen = axes * point;
      const Eigen::Vector3d radius = Eigen::Vector3d::Constant(sheet.list.rods[r].radius);
      box.extend(seen - radius);
      box.extend(seen + radius);
    }
  const Eigen::Vector3d sizes = box.sizes();
  return tenths(sizes.x()) + " x " + tenths(sizes.y()) + " x " + tenths(sizes.z()) + " mm";
}

void add_facts(Book& book, const Sheet& sheet) {
  const model::Design& design = sheet.design;
  book.table({{"rod", Align::left, true},
              {"", Align::left},
              {"length mm"},
              {"cut mm"},
              {"section", Align::left},
              {"material", Align::left},
              {"weight"}},
             rod_rows(sheet));
  const auto cables = static_cast<int>(sheet.list.cables.size());
  const auto mass = sheet.list.rods_mass();
  book.paragraph("In all " + tenths(sheet.list.rods_cut()) + " mm of rod" +
                 (mass ? ", " + model::mass_in_words(*mass) : std::string(", weight not known")) +
                 ", and " + counted(cables, "cable") + " cut from " +
                 tenths(sheet.list.cables_cut()) + " mm.");
  book.paragraph("The rods fit into a box of " + box_words(sheet) +
                 " (width, height and depth of the view from the front).");
  if (design.error)
    book.paragraph("The drawing is within " + significant(design.error->max_percent) +
                   " % of the shape that was asked for (of its size).");
  book.paragraph("Lengths on this sheet are in mm, forces in N; design.json is in " +
                 design.length_unit + " and " + design.force_unit + ".");
}

void add_contents(Book& book) {
  book.need(10);
  std::string words;
  for (const Section& section : book.known().sections)
    if (section.page > 1)
      words +=
          (words.empty() ? "" : "  ·  ") + section.title + ", p. " + std::to_string(section.page);
  book.paragraph(words, {2.7, false, soft_ink});
}

}  // namespace

void add_cover(Book& book, const Sheet& sheet) {
  book.section(sheet.title);
  book.paragraph("Building sheet, by tencer " TENCER_VERSION, {3.1, false, soft_ink});
  add_verdict(book, sheet);
  add_drawing(book, sheet);
  book.paragraph(
      "Cables have numbers, rods letters. A ring is where a rod starts, the arrow which way its "
      "lengths are measured; a rod with a gap passes under.");
  add_facts(book, sheet);
  add_contents(book);
}

void add_views(Book& book, const Sheet& sheet) {
  book.section("From three sides");
  draw_three_views(book, sheet.solid, principal_axes(points_of(sheet.solid)), {}, book.height(),
                   {"From the front", "From above", "From the right"});
}

}  // namespace tencer::app
