#include "curves/curve_svg.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <pugixml.hpp>
#include <utility>

#include "curves/svg_path.hpp"
#include "text/bad_input.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

using Eigen::Affine2d;
using Eigen::Vector2d;

// A length with its unit: what is left after the number.
struct Length {
  double number = 0.0;
  std::string unit;
};

std::optional<Length> read_length(std::string_view text) {
  const std::size_t end = text.find_first_not_of("+-.0123456789eE \t");
  // "1e" of "1em" is no number; lengths in em are none we know either way.
  const auto parts = words(text.substr(0, end));
  const auto number = parts.size() == 1 ? to_number(parts[0]) : std::nullopt;
  if (!number || !std::isfinite(*number)) return std::nullopt;
  return Length{*number, end == std::string_view::npos ? "" : std::string(text.substr(end))};
}

// The millimetres of a unit that is one of length; px and none are not.
std::optional<double> millimetres(const std::string& unit) {
  constexpr std::array<std::pair<std::string_view, double>, 5> units{
      {{"mm", 1}, {"cm", 10}, {"in", 25.4}, {"pt", 25.4 / 72}, {"pc", 25.4 / 6}}};
  for (const auto& [name, size] : units)
    if (name == unit) return size;
  return std::nullopt;
}

Eigen::Vector3d flat(const Vector2d& point) { return {point.x(), point.y(), 0.0}; }

class SvgReader {
 public:
  SvgReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  CurveFile read() {
    pugi::xml_document document;
    const auto parsed = document.load_buffer(text_.data(), text_.size());
    if (!parsed)
      fail(where(parsed.offset), std::string("is not valid XML: ") + parsed.description());
    const pugi::xml_node root = document.document_element();
    if (local_name(root) != "svg")
      fail(file_, "expected an SVG drawing, found XML of " + quoted(root.name()));
    CurveFile result;
    find_ids(root);
    walk(root, page(root, result), 0);
    if (strokes_.empty())
      fail(file_, others_ > 0 ? "the drawing holds no paths or shapes, only text, pictures or "
                                "copies of other files; convert these to paths before export"
                              : "the drawing holds no paths, lines or shapes");
    add_strokes(strokes_, result);
    if (others_ > 0)
      result.notes.push_back(file_ + ": text, pictures and copies of other files are left out, " +
                             std::to_string(others_) + " of them");
    return result;
  }

 private:
  // Counts on from the last place asked for, as most come in order.
  std::string where(std::ptrdiff_t offset) {
    const auto end = std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(text_));
    if (end < counted_) counted_ = line_ = 0;
    line_ += std::count(text_.begin() + counted_, text_.begin() + end, '\n');
    counted_ = end;
    return file_ + ":" + std::to_string(1 + line_);
  }
  static std::string_view local_name(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    return name.substr(name.find(':') == std::string_view::npos ? 0 : name.find(':') + 1);
  }

  // From the drawing's numbers to those of the curves, y up: millimetres where the page says how
  // large it is, else as they are.
  Affine2d page(const pugi::xml_node& root, CurveFile& result) {
    Affine2d upright = Affine2d::Identity();
    upright.linear() << 1, 0, 0, -1;
    const auto width = read_length(root.attribute("width").value());
    const auto size = width ? millimetres(width->unit) : std::nullopt;
    if (!size || !(width->number > 0)) {
      result.notes.push_back(file_ +
                             ": the drawing says no unit of length; its numbers are taken as they "
                             "are, and --unit says what they are");
      return upright;
    }
    result.length_unit = "mm";
    const std::string there = where(root.offset_debug());
    const auto box = svg_numbers(root.attribute("viewBox").value(), there + ": viewBox");
    if (!box.empty() && (box.size() != 4 || !(box[2] > 0)))
      fail(there, "expected a viewBox of four numbers, the third, its width, positive");
    // Without a box the numbers are pixels, 96 an inch.
    const double scale = box.empty() ? 25.4 / 96 : width->number * *size / box[2];
    return Affine2d(Eigen::Scaling(scale)) * upright;
  }

  void find_ids(const pugi::xml_node& root) {
    struct Finder : pugi::xml_tree_walker {
      std::map<std::string_view, pugi::xml_node> found;
      bool for_each(pugi::xml_node& node) override {
        if (const pugi::xml_attribute id = node.attribute("id")) found.emplace(id.value(), node);
        return true;
      }
    } finder;
    pugi::xml_node(root).traverse(finder);
    by_id_ = std::move(finder.found);
  }

  void walk(const pugi::xml_node& parent, const Affine2d& above, int depth) {
    constexpr int deepest = 200;
    constexpr std::array<std::string_view, 8> unseen{
        "defs", "clipPath", "mask", "marker", "pattern", "symbol", "metadata", "linearGradient"};
    if (depth > deepest) fail(where(parent.offset_debug()), "groups are nested more than 200 deep");
    for (const pugi::xml_node& node : parent.children())
      if (std::ranges::find(unseen, local_name(node)) == unseen.end()) visit(node, above, depth);
  }

  void visit(const pugi::xml_node& node, const Affine2d& above, int depth) {
    constexpr std::array<std::string_view, 3> no_curve{"text", "image", "foreignObject"};
    const std::string_view name = local_name(node);
    if (name.empty() || hidden(node)) return;
    if (std::ranges::find(no_curve, name) != no_curve.end()) {
      ++others_;
      return;
    }
    const std::string there = where(node.offset_debug()) + ": " + std::string(name);
    const Affine2d transform = above * transform_of(node, there);
    if (name == "g" || name == "svg" || name == "a" || name == "switch")
      walk(node, transform, depth + 1);
    else if (name == "use")
      copy(node, transform, depth, there);
    else
      draw(node, name, transform, there);
  }

  // Another element of the file once more.
  void copy(const pugi::xml_node& node, const Affine2d& above, int depth,
            const std::string& there) {
    constexpr int most = 10000;
    const std::string_view plain = node.attribute("href").value();
    const std::string_view reference = plain.empty() ? node.attribute("xlink:href").value() : plain;
    const auto found = reference.starts_with('#') ? by_id_.find(reference.substr(1)) : by_id_.end();
    if (found == by_id_.end()) {
      ++others_;
      return;
    }
    if (++copies_ > most)
      fail(there, "there are more than 10000 copies, or one of itself; draw the curves themselves");
    Affine2d transform = above;
    transform.translate(Vector2d(number(node, "x", there), number(node, "y", there)));
    // A symbol is seen in its copies only.
    if (local_name(found->second) == "symbol")
      walk(found->second, transform, depth + 1);
    else if (depth < 200)
      visit(found->second, transform, depth + 1);
    else
      fail(there, "copies are nested more than 200 deep");
  }

  static bool hidden(const pugi::xml_node& node) {
    const std::string_view style = node.attribute("style").value();
    return node.attribute("display").value() == std::string_view("none") ||
           node.attribute("visibility").value() == std::string_view("hidden") ||
           style.find("display:none") != std::string_view::npos ||
           style.find("display: none") != std::string_view::npos;
  }

  // "translate(1 2) rotate(30)"
  static Affine2d transform_of(const pugi::xml_node& node, const std::string& there) {
    std::string_view text = node.attribute("transform").value();
    Affine2d result = Affine2d::Identity();
    for (;;) {
      text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n,"), text.size()));
      if (text.empty()) return result;
      const std::size_t open = text.find('(');
      const std::size_t close = text.find(')');
      if (open == std::string_view::npos || close == std::string_view::npos || close < open)
        fail(there, "expected a transform such as rotate(30), found " + quoted(text.substr(0, 20)));
      const auto name = words(text.substr(0, open));
      result = result * one_transform(name.empty() ? "" : name[0],
                                      svg_numbers(text.substr(open + 1, close - open - 1), there),
                                      there);
      text.remove_prefix(close + 1);
    }
  }

  static Affine2d one_transform(std::string_view name, const std::vector<double>& n,
                                const std::string& there) {
    const auto radians = [&] { return n[0] / 180 * std::numbers::pi; };
    Affine2d result = Affine2d::Identity();
    if (name == "matrix" && n.size() == 6) {
      result.matrix().topRows<2>() << n[0], n[2], n[4], n[1], n[3], n[5];
    } else if (name == "translate" && (n.size() == 1 || n.size() == 2)) {
      result.translate(Vector2d(n[0], n.size() == 2 ? n[1] : 0));
    } else if (name == "scale" && (n.size() == 1 || n.size() == 2)) {
      result.scale(Vector2d(n[0], n.back()));
    } else if (name == "rotate" && (n.size() == 1 || n.size() == 3)) {
      const Vector2d center = n.size() == 3 ? Vector2d(n[1], n[2]) : Vector2d(0, 0);
      result.translate(center).rotate(radians()).translate(-center);
    } else if (name == "skewX" && n.size() == 1) {
      result.matrix()(0, 1) = std::tan(radians());
    } else if (name == "skewY" && n.size() == 1) {
      result.matrix()(1, 0) = std::tan(radians());
    } else {
      fail(there,
           "unknown transform " + quoted(name) + " of " + std::to_string(n.size()) + " numbers");
    }
    return result;
  }

  void draw(const pugi::xml_node& node, std::string_view name, const Affine2d& transform,
            const std::string& there) {
    std::vector<Stroke> strokes;
    if (name == "path")
      strokes = svg_strokes(node.attribute("d").value(), there);
    else if (name == "polyline" || name == "polygon")
      strokes =
          polyline(svg_numbers(node.attribute("points").value(), there), name == "polygon", there);
    else if (name == "line")
      strokes = polyline({number(node, "x1", there), number(node, "y1", there),
                          number(node, "x2", there), number(node, "y2", there)},
                         false, there);
    else if (name == "rect")
      strokes = rectangle(node, there);
    else if (name == "circle" || name == "ellipse")
      strokes = ellipse(node, name == "circle", there);
    for (Stroke& stroke : strokes) {
      for (Piece& piece : stroke.pieces)
        piece.at = [at = std::move(piece.at), transform](double t) {
          return flat(transform * Vector2d(at(t).head<2>()));
        };
      strokes_.push_back(std::move(stroke));
    }
  }

  static double number(const pugi::xml_node& node, const char* key, const std::string& there) {
    const std::string_view text = node.attribute(key).value();
    if (text.empty()) return 0.0;
    const auto length = read_length(text);
    if (!length || std::abs(length->number) > largest_number ||
        (!length->unit.empty() && length->unit != "px"))
      fail(there, std::string(key) + ": expected a number without a unit, found " + quoted(text));
    return length->number;
  }

  static std::vector<Stroke> polyline(const std::vector<double>& n, bool closed,
                                      const std::string& there) {
    if (n.size() % 2 != 0)
      fail(there, "expected pairs of numbers, found " + std::to_string(n.size()) + " numbers");
    std::string data = "M";
    for (const double one : n) data += ' ' + to_text(one);
    if (n.empty()) return {};
    return svg_strokes(data + (closed ? "Z" : ""), there);
  }

  static std::vector<Stroke> rectangle(const pugi::xml_node& node, const std::string& there) {
    const double x = number(node, "x", there), y = number(node, "y", there);
    const double w = number(node, "width", there), h = number(node, "height", there);
    if (!(w > 0 && h > 0)) return {};  // not drawn
    double rx = number(node, node.attribute("rx") ? "rx" : "ry", there);
    double ry = number(node, node.attribute("ry") ? "ry" : "rx", there);
    rx = std::clamp(rx, 0.0, w / 2);
    ry = std::clamp(ry, 0.0, h / 2);
    if (rx == 0 || ry == 0) return polyline({x, y, x + w, y, x + w, y + h, x, y + h}, true, there);
    const auto corner = [&](double px, double py) {
      return 'A' + to_text(rx) + ' ' + to_text(ry) + " 0 0 1 " + to_text(px) + ' ' + to_text(py);
    };
    return svg_strokes('M' + to_text(x + rx) + ' ' + to_text(y) + 'H' + to_text(x + w - rx) +
                           corner(x + w, y + ry) + 'V' + to_text(y + h - ry) +
                           corner(x + w - rx, y + h) + 'H' + to_text(x + rx) +
                           corner(x, y + h - ry) + 'V' + to_text(y + ry) + corner(x + rx, y) + 'Z',
                       there);
  }

  static std::vector<Stroke> ellipse(const pugi::xml_node& node, bool round,
                                     const std::string& there) {
    const double rx = number(node, round ? "r" : "rx", there);
    const double ry = number(node, round ? "r" : "ry", there);
    if (!(rx > 0 && ry > 0)) return {};  // not drawn
    return {{{arc(flat({number(node, "cx", there), number(node, "cy", there)}), {rx, 0, 0},
                  {0, ry, 0}, 0, 2 * std::numbers::pi)},
             true,
             there}};
  }

  std::string_view text_;
  const std::string& file_;
  std::map<std::string_view, pugi::xml_node> by_id_;
  std::vector<Stroke> strokes_;
  int others_ = 0;
  int copies_ = 0;
  std::ptrdiff_t counted_ = 0;  // of the text, with so many lines before
  std::ptrdiff_t line_ = 0;
};

}  // namespace

CurveFile parse_svg(std::string_view text, const std::string& file) {
  return SvgReader(text, file).read();
}

}  // namespace tencer::io
