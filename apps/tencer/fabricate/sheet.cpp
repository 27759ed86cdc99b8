#include "fabricate/sheet.hpp"

#include <algorithm>
#include <tencer/core/names.hpp>

#include "fabricate/strips.hpp"

namespace tencer::app {
namespace {

// In one line, whatever the file says.
std::string title_of(const model::Design& design) {
  std::string title = design.name.empty() ? "tencer design" : design.name;
  for (char& c : title)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  return title;
}

Contents draw(const Sheet& sheet, const Contents& known, std::string* pdf) {
  Book book(sheet.paper, sheet.title, known);
  add_cover(book, sheet);
  add_views(book, sheet);
  add_rods(book, sheet);
  add_cables(book, sheet);
  add_order(book, sheet);
  add_supports(book, sheet);
  add_purchase(book, sheet);
  add_labels(book, sheet);
  add_strips(book, sheet.list);
  *pdf = book.finish();
  return book.contents();
}

std::string strip_name(int rod) { return "strip-" + core::rod_name(rod) + ".svg"; }

}  // namespace

core::Expected<Sheet> make_sheet(const io::CheckedDesign& read, const SheetOptions& options) {
  const model::Design& design = read.design;
  Sheet sheet{.title = title_of(design),
              .design = design,
              .check = read.check,
              .paper = options.paper,
              .list = fabricate::cut_list(design, options.allowances),
              .offers = options.offers,
              .solid = solid_of(design)};
  auto rods = fabricate::buy_rods(sheet.list, options.offers.rods);
  if (!rods) return rods.error();
  auto cables = fabricate::buy_cables(sheet.list, options.offers.cables);
  if (!cables) return cables.error();
  sheet.rods = *std::move(rods);
  sheet.cables = *std::move(cables);
  sheet.order = tying_order(design, sheet.list);
  const std::span<const geometry::Polyline> curves = sheet.solid.curves;
  sheet.threading = fabricate::threading(curves.first(static_cast<std::size_t>(sheet.solid.rods)));
  return sheet;
}

std::vector<std::string> not_looked_at(const Sheet& sheet) {
  auto sections =
      model::not_looked_at(sheet.check ? sheet.check->lines : std::vector<model::CheckLine>{});
  // The search certifies its design without a check.
  if (sheet.design.certificate && sheet.design.certificate->stable) std::erase(sections, "stands");
  return sections;
}

std::string sheet_pdf(const Sheet& sheet) {
  std::string pdf;
  // The pages have to be counted before their numbers can be printed.
  const Contents contents = draw(sheet, {}, &pdf);
  draw(sheet, contents, &pdf);
  return pdf;
}

std::vector<io::NamedText> sheet_files(const Sheet& sheet) {
  std::vector<io::NamedText> files{{"sheet.pdf", sheet_pdf(sheet)}};
  for (io::NamedText& table : sheet_tables(sheet)) files.push_back(std::move(table));
  for (int r = 0; r < sheet.solid.rods; ++r)
    files.push_back({strip_name(r), strip_svg(sheet.list, r)});
  return files;
}

std::optional<core::Error> write_sheet(const std::filesystem::path& folder, const Sheet& sheet) {
  if (auto error = io::write_files(folder, sheet_files(sheet))) return error;
  std::error_code failed;
  for (int r = sheet.solid.rods;; ++r) {
    const std::filesystem::path strip = folder / strip_name(r);
    if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(strip, failed)))
      return std::nullopt;
    if (!std::filesystem::remove(strip, failed))
      return core::Error{
          strip.string(),
          "is of a sheet that was here before, and cannot be removed: " + failed.message()};
  }
}

}  // namespace tencer::app
