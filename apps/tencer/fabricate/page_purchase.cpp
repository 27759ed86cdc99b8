// What to buy, and from which bar or coil each piece is cut.
#include <tencer/core/names.hpp>
#include <tencer/core/words.hpp>
#include <tencer/fabricate/names.hpp>

#include "fabricate/sheet.hpp"
#include "fabricate/words.hpp"

namespace tencer::app {
namespace {

using core::counted;
using fabricate::tenths;

// What the material of one kind is called.
struct Kind {
  std::string material{};  // "rod"
  std::string bar{};       // "bar"
  std::string (*name)(int) = nullptr;
};

std::string money(double cost) {
  const auto cents = static_cast<long long>(std::llround(100 * cost));
  const std::string rest = std::to_string(100 + cents % 100);
  return std::to_string(cents / 100) + '.' + rest.substr(1);
}

std::string cost_words(const fabricate::Purchase& purchase, double price) {
  return "Cost " + money(*purchase.cost) + ", at " + money(price) + " per metre.";
}

std::vector<Cells> bar_rows(const fabricate::Purchase& purchase, double stock, const Kind& kind) {
  std::vector<Cells> rows;
  for (std::size_t b = 0; b < purchase.packing->bars.size(); ++b) {
    double rest = stock;
    std::string pieces;
    for (const int p : purchase.packing->bars[b]) {
      const fabricate::Piece& piece = purchase.pieces[p];
      rest -= piece.length;
      pieces += (pieces.empty() ? "" : ",  ") + kind.name(piece.of) + ": " + tenths(piece.length);
    }
    rows.push_back({std::to_string(b + 1), pieces, tenths(std::max(0.0, rest))});
  }
  return rows;
}

// Rows whose pieces would not fit on a line are continued on the next.
std::vector<Cells> within(Canvas& canvas, double width, const std::vector<Cells>& rows) {
  std::vector<Cells> result;
  for (const Cells& row : rows) {
    std::string rest = row[1];
    Cells line{row[0], "", row[2]};
    while (canvas.width_of(rest, {3.0}) > width) {
      std::size_t end = rest.rfind(",  ");
      while (end != std::string::npos && end > 0 &&
             canvas.width_of(rest.substr(0, end), {3.0}) > width)
        end = rest.rfind(",  ", end - 1);
      if (end == std::string::npos) break;
      line[1] = rest.substr(0, end + 1);
      result.push_back(line);
      line = {"", "", ""};
      rest = rest.substr(end + 3);
    }
    line[1] = rest;
    result.push_back(line);
  }
  return result;
}

// A rod longer than a bar is made of several.
std::string splice_words(const fabricate::Splice& splice) {
  std::string text =
      "Rod " + core::rod_name(splice.rod) + " is spliced at " + tenths(splice.from) + " mm";
  if (splice.to > splice.from) text += ", its bars overlapping up to " + tenths(splice.to) + " mm";
  if (splice.nearest_mark)
    text += "; the nearest mark is " + tenths(*splice.nearest_mark) + " mm from there";
  return text + '.';
}

void add_kind(Book& book, const fabricate::Purchase& purchase, const fabricate::Offer& offer,
              const Kind& kind) {
  book.heading(kind.material);
  const auto pieces = static_cast<int>(purchase.pieces.size());
  std::string words = counted(pieces, "piece") + ", " + tenths(purchase.needed) + " mm.";
  if (purchase.packing) {
    const auto bars = static_cast<int>(purchase.packing->bars.size());
    const int least = purchase.packing->lower_bound;
    words += " Buy " + counted(bars, kind.bar) + " of " + tenths(*offer.stock) + " mm";
    words += bars == least ? ", the fewest possible"
                           : " (no way of cutting needs fewer than " + std::to_string(least) + ")";
    words += "; " + tenths(purchase.bought - purchase.needed) + " mm are left over.";
  }
  book.paragraph(words);
  if (purchase.cost) book.paragraph(cost_words(purchase, *offer.price_per_metre));
  if (!purchase.packing) return;
  const auto rows = bar_rows(purchase, *offer.stock, kind);
  book.table({{kind.bar, Align::right, true}, {"pieces mm", Align::left}, {"left over mm"}},
             within(book.canvas(), book.width() - 45, rows));
}

}  // namespace

void add_purchase(Book& book, const Sheet& sheet) {
  book.section("What to buy");
  add_kind(book, sheet.rods, sheet.offers.rods, {"Rod", "bar", core::rod_name});
  for (const fabricate::Splice& splice : fabricate::splices(sheet.list, sheet.rods))
    book.paragraph(splice_words(splice));
  if (!sheet.list.cables.empty())
    add_kind(book, sheet.cables, sheet.offers.cables, {"Cable", "coil", core::cable_name});
  if (sheet.rods.cost && sheet.cables.cost)
    book.paragraph("Both together " + money(*sheet.rods.cost + *sheet.cables.cost) + ".",
                   {3.1, true});
  if (!sheet.rods.packing || !sheet.cables.packing)
    book.paragraph(
        "Options of tencer fabricate: --stock, the length of a bar, and --coil, that of a coil, "
        "say how "
        "to cut them (what a saw takes is not counted); --price-rod and --price-cable what it "
        "costs.",
        {2.7, false, soft_ink});
}

}  // namespace tencer::app
