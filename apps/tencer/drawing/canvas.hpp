// Drawing on paper: lines, areas and words in mm from the upper left corner, as PDF, SVG or PNG by
// Cairo, which no other file sees.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>

struct _cairo;

namespace tencer::app {

struct Colour {
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;
};
inline constexpr Colour ink{0.11, 0.14, 0.17};
inline constexpr Colour soft_ink{0.42, 0.46, 0.50};
inline constexpr Colour hairline{0.78, 0.80, 0.83};
inline constexpr Colour tint{0.955, 0.96, 0.965};
inline constexpr Colour white{1.0, 1.0, 1.0};
inline constexpr Colour accent{0.78, 0.18, 0.07};  // cables, and what to look at
inline constexpr Colour good{0.11, 0.48, 0.27};
Colour rod_colour(int rod);

struct Pen {
  Colour colour = ink;
  double width = 0.2;
  bool dashed = false;
};

enum class Align { left, centre, right };

struct Font {
  double size = 3.0;
  bool bold = false;
  Colour colour = ink;
  Align align = Align::left;
};

// Columns are points.
using Path = Eigen::Matrix2Xd;

class Canvas {
 public:
  explicit Canvas(_cairo* context) : context_(context) {}

  void line(double x0, double y0, double x1, double y1, const Pen& pen = {});
  void path(const Path& points, const Pen& pen);
  void border(const Path& corners, const Pen& pen);  // closed
  void area(const Path& corners, const Colour& fill);
  void rectangle(double x, double y, double width, double height, const Colour& fill);
  void frame(double x, double y, double width, double height, const Pen& pen = {});
  void disc(const Eigen::Vector2d& centre, double radius, const Colour& fill);
  // y is the base line.
  void text(double x, double y, const std::string& words, const Font& font = {});
  double width_of(const std::string& words, const Font& font = {});
  // The words, or as many letters as fit into the width and dots.
  std::string fitting(const std::string& words, double width, const Font& font = {});

 private:
  _cairo* context_;
};

// Pages of one size, one after the other.
class Pdf {
 public:
  Pdf(double width, double height, const std::string& title);
  ~Pdf();
  Pdf(const Pdf&) = delete;
  Pdf& operator=(const Pdf&) = delete;

  Canvas& page() { return canvas_; }
  void end_page();
  // The file. Throws std::runtime_error when Cairo had no memory, or no font.
  std::string finish();

 private:
  struct Surface;
  std::unique_ptr<Surface> surface_;
  Canvas canvas_;
};

// One drawing, in mm. All throw like Pdf::finish(). The title says what it shows to those who
// cannot see it.
using Draw = std::function<void(Canvas&)>;
std::string svg_drawing(double width, double height, const std::string& title, const Draw& draw);
std::string pdf_drawing(double width, double height, const std::string& title, const Draw& draw);
std::string png_drawing(double width, double height, double dots_per_inch, const Draw& draw);

}  // namespace tencer::app
