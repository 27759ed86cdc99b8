#include "drawing/canvas.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>

namespace tencer::app {
namespace {

constexpr double points_per_mm = 72 / 25.4;

cairo_status_t append(void* text, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("Cairo: ") + cairo_status_to_string(status));
}

}  // namespace

// A surface that writes into a text, and what draws on it.
class TextSurface {
 public:
  TextSurface() = default;
  TextSurface(const TextSurface&) = delete;
  TextSurface& operator=(const TextSurface&) = delete;
  ~TextSurface() {
    cairo_destroy(context_);
    cairo_surface_destroy(surface_);
  }

  std::string& text() { return text_; }
  cairo_surface_t* surface() { return surface_; }
  cairo_t* begin(cairo_surface_t* surface, double unit) {
    surface_ = surface;
    context_ = cairo_create(surface);
    cairo_scale(context_, unit, unit);
    cairo_set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
    // Letters are as wide on every page, whatever its resolution.
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(context_, options);
    cairo_font_options_destroy(options);
    return context_;
  }
  std::string finish() {
    check(cairo_status(context_));
    cairo_surface_finish(surface_);
    check(cairo_surface_status(surface_));
    return std::move(text_);
  }

 private:
  std::string text_;
  cairo_surface_t* surface_ = nullptr;
  cairo_t* context_ = nullptr;
};

namespace {

void use(cairo_t* context, const Colour& colour) {
  cairo_set_source_rgb(context, colour.red, colour.green, colour.blue);
}

void use(cairo_t* context, const Font& font) {
  cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         font.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, font.size);
  use(context, font.colour);
}

void stroke(cairo_t* context, const Pen& pen) {
  use(context, pen.colour);
  cairo_set_line_width(context, pen.width);
  const double dash = 1.2;
  cairo_set_dash(context, &dash, pen.dashed ? 1 : 0, 0);
  cairo_stroke(context);
}

// How many bytes the letter of UTF-8 takes that begins here; 0: none does.
std::size_t letter_size(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t size = lead < 0xC2   ? 0
                           : lead < 0xE0 ? 2
                           : lead < 0xF0 ? 3
                           : lead < 0xF5 ? 4
                                         : 0;
  if (text.size() < size) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  // Too long for what it says, half of a pair, or beyond the last letter there is.
  const bool wrong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xED && byte(1) >= 0xA0) ||
                     (lead == 0xF0 && byte(1) < 0x90) || (lead == 0xF4 && byte(1) >= 0x90);
  return wrong ? 0 : size;
}

// What is no text, such as the name of a file may be, makes Cairo give up.
std::string readable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t size = letter_size(text);
    result += size > 0 ? text.substr(0, size) : "?";
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return result;
}

std::string escaped(const std::string& text) {
  std::string xml;
  for (const char c : text) {
    if (c == '&')
      xml += "&amp;";
    else if (c == '<')
      xml += "&lt;";
    else
      xml += c;
  }
  return xml;
}

void trace(cairo_t* context, const Path& points) {
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    cairo_line_to(context, points(0, i), points(1, i));  // the first moves there
}

}  // namespace

Colour rod_colour(int rod) {
  constexpr std::array<Colour, 6> colours{{{0.25, 0.49, 0.77},
                                           {0.18, 0.64, 0.49},
                                           {0.54, 0.41, 0.78},
                                           {0.39, 0.52, 0.62},
                                           {0.73, 0.58, 0.22},
                                           {0.72, 0.39, 0.55}}};
  return colours[static_cast<std::size_t>(rod) % colours.size()];
}

void Canvas::line(double x0, double y0, double x1, double y1, const Pen& pen) {
  cairo_move_to(context_, x0, y0);
  cairo_line_to(context_, x1, y1);
  stroke(context_, pen);
}

void Canvas::path(const Path& points, const Pen& pen) {
  trace(context_, points);
  stroke(context_, pen);
}

void Canvas::border(const Path& corners, const Pen& pen) {
  trace(context_, corners);
  cairo_close_path(context_);
  stroke(context_, pen);
}

void Canvas::area(const Path& corners, const Colour& fill) {
  trace(context_, corners);
  use(context_, fill);
  cairo_fill(context_);
}

void Canvas::rectangle(double x, double y, double width, double height, const Colour& fill) {
  cairo_rectangle(context_, x, y, width, height);
  use(context_, fill);
  cairo_fill(context_);
}

void Canvas::frame(double x, double y, double width, double height, const Pen& pen) {
  cairo_rectangle(context_, x, y, width, height);
  stroke(context_, pen);
}

void Canvas::disc(const Eigen::Vector2d& centre, double radius, const Colour& fill) {
  cairo_arc(context_, centre.x(), centre.y(), radius, 0, 2 * std::numbers::pi);
  use(context_, fill);
  cairo_fill(context_);
}

void Canvas::text(double x, double y, const std::string& words, const Font& font) {
  const double width = font.align == Align::left ? 0 : width_of(words, font);
  use(context_, font);
  cairo_move_to(context_, x - (font.align == Align::centre ? width / 2 : width), y);
  cairo_show_text(context_, readable(words).c_str());
  cairo_new_path(context_);
}

double Canvas::width_of(const std::string& words, const Font& font) {
  use(context_, font);
  cairo_text_extents_t extents;
  cairo_text_extents(context_, readable(words).c_str(), &extents);
  return extents.x_advance;
}

std::string Canvas::fitting(const std::string& words, double width, const Font& font) {
  if (width_of(words, font) <= width) return words;
  std::string part = words;
  while (!part.empty() && width_of(part + "...", font) > width) {
    // A letter may be several bytes, of which all but the first begin with the bits 10.
    while (part.size() > 1 && (part.back() & 0xC0) == 0x80) part.pop_back();
    part.pop_back();
  }
  return part + "...";
}

struct Pdf::Surface {
  TextSurface drawing;
};

Pdf::Pdf(double width, double height, const std::string& title)
    : surface_(std::make_unique<Surface>()), canvas_(nullptr) {
  TextSurface& drawing = surface_->drawing;
  cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(
      append, &drawing.text(), width * points_per_mm, height * points_per_mm);
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, readable(title).c_str());
  // The same design gives the same bytes: no date.
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "");
  canvas_ = Canvas(drawing.begin(surface, points_per_mm));
}

Pdf::~Pdf() = default;

void Pdf::end_page() { cairo_surface_show_page(surface_->drawing.surface()); }

std::string Pdf::finish() { return surface_->drawing.finish(); }

std::string svg_drawing(double width, double height, const std::string& title, const Draw& draw) {
  TextSurface drawing;
  cairo_surface_t* surface =
      cairo_svg_surface_create_for_stream(append, &drawing.text(), width, height);
  cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_MM);
  Canvas canvas(drawing.begin(surface, 1));
  draw(canvas);
  std::string svg = drawing.finish();
  // Cairo counts the surfaces of a process; the same drawing gives the same bytes.
  constexpr std::string_view counted = " id=\"surface";
  if (const std::size_t id = svg.find(counted); id != std::string::npos)
    svg.erase(id, svg.find('"', id + counted.size()) + 1 - id);
  return svg.insert(svg.find('>', svg.find("<svg")) + 1, "\n<title>" + escaped(title) + "</title>");
}

std::string pdf_drawing(double width, double height, const std::string& title, const Draw& draw) {
  Pdf pdf(width, height, title);
  draw(pdf.page());
  pdf.end_page();
  return pdf.finish();
}

std::string png_drawing(double width, double height, double dots_per_inch, const Draw& draw) {
  const double dots_per_mm = dots_per_inch / 25.4;
  TextSurface drawing;
  cairo_surface_t* surface = cairo_image_surface_create(
      CAIRO_FORMAT_RGB24, static_cast<int>(std::ceil(width * dots_per_mm)),
      static_cast<int>(std::ceil(height * dots_per_mm)));
  Canvas canvas(drawing.begin(surface, dots_per_mm));
  // Also the dots that the paper covers in part.
  canvas.rectangle(0, 0, width + 1, height + 1, white);
  draw(canvas);
  check(cairo_surface_status(surface));
  check(cairo_surface_write_to_png_stream(surface, append, &drawing.text()));
  return drawing.finish();
}

}  // namespace tencer::app
