// All that the sheet of a design says, found out before anything is drawn.
#pragma once

#include <optional>
#include <string>
#include <tencer/fabricate/cut_list.hpp>
#include <tencer/fabricate/purchase.hpp>
#include <tencer/fabricate/threading.hpp>
#include <tencer/io/check.hpp>
#include <tencer/io/file.hpp>
#include <vector>

#include "drawing/solid.hpp"
#include "fabricate/book.hpp"
#include "fabricate/tying.hpp"

namespace tencer::app {

// At which lengths and prices material is sold.
struct Offers {
  fabricate::Offer rods{};
  fabricate::Offer cables{};
};

struct SheetOptions {
  PaperSize paper = a4;
  fabricate::Allowances allowances{};
  Offers offers{};
};

struct Sheet {
  std::string title{};
  model::Design design{};
  std::optional<io::FiledCheck> check{};  // not set: nobody checked the design
  PaperSize paper = a4;
  fabricate::CutList list{};
  TyingOrder order{};
  fabricate::Threading threading{};
  Offers offers{};
  fabricate::Purchase rods{};
  fabricate::Purchase cables{};
  Solid solid{};
};

// Errors: options that the design cannot be cut with.
core::Expected<Sheet> make_sheet(const io::CheckedDesign& read, const SheetOptions& options);

// What of a check nobody did, "holds" and so on; all of it when there is none.
std::vector<std::string> not_looked_at(const Sheet& sheet);

// sheet.pdf, the tables as CSV, and a strip-NAME.svg for each rod.
std::vector<io::NamedText> sheet_files(const Sheet& sheet);

// Writes these files, and removes the strips of further rods that a sheet in this folder had
// before.
std::optional<core::Error> write_sheet(const std::filesystem::path& folder, const Sheet& sheet);

// The parts of the PDF, one after the other.
std::string sheet_pdf(const Sheet& sheet);
void add_cover(Book& book, const Sheet& sheet);
void add_views(Book& book, const Sheet& sheet);
void add_rods(Book& book, const Sheet& sheet);
void add_cables(Book& book, const Sheet& sheet);
void add_order(Book& book, const Sheet& sheet);
void add_supports(Book& book, const Sheet& sheet);
void add_purchase(Book& book, const Sheet& sheet);
void add_labels(Book& book, const Sheet& sheet);

// rods.csv, marks.csv, cables.csv, anchors.csv, pieces.csv
std::vector<io::NamedText> sheet_tables(const Sheet& sheet);

}  // namespace tencer::app
