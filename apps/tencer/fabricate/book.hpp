// Pages with a heading and a foot, filled from the top down: paragraphs, tables, and room for
// drawings.
#pragma once

#include <string>
#include <vector>

#include "drawing/canvas.hpp"

namespace tencer::app {

struct PaperSize {
  double width = 0.0;
  double height = 0.0;
};
inline constexpr PaperSize a4{210.0, 297.0};
inline constexpr PaperSize letter{215.9, 279.4};

// A section's title and first page, for the list of contents.
struct Section {
  std::string title;
  int page = 0;
};
// What is known of a book once it has been drawn, and printed in it the next time.
struct Contents {
  std::vector<Section> sections{};
  int pages = 0;
};

struct Column {
  std::string title{};
  Align align = Align::right;
  bool bold = false;
};
using Cells = std::vector<std::string>;

class Book {
 public:
  // title: at the foot of every page. known: of the same book.
  Book(const PaperSize& paper, std::string title, Contents known);

  Canvas& canvas() { return pdf_.page(); }
  const Contents& known() const { return known_; }
  double left() const { return 18; }
  double right() const { return paper_.width - 18; }
  double width() const { return right() - left(); }
  double bottom() const { return paper_.height - 20; }
  double height() const { return bottom() - 30; }  // below the heading of a section
  double y() const { return y_; }
  void skip(double height) { y_ += height; }

  void section(const std::string& title);  // on a new page
  // A new page of the same section, unless so much is left of this one.
  void need(double height);
  void heading(const std::string& words);
  void paragraph(const std::string& words, const Font& font = {.size = 3.1});
  // Rows in as many columns side by side as fit, down one and then the next; over several pages
  // where they have to, each with the titles.
  void table(const std::vector<Column>& columns, const std::vector<Cells>& rows);

  Contents contents() const { return {sections_, page_}; }
  std::string finish();

 private:
  void begin_page();
  void end_page();

  PaperSize paper_;
  std::string title_;
  Contents known_;
  Pdf pdf_;
  std::vector<Section> sections_;
  int page_ = 0;
  double y_ = 0;
};

}  // namespace tencer::app
