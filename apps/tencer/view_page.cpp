#include "view_page.hpp"

#include <array>
#include <string_view>
#include <tencer/core/error.hpp>
#include <utility>

#include "drawing/picture.hpp"
#include "view_template.hpp"

namespace tencer::app {
namespace {

// JSON inside a script element: only strings hold a '<', and there it may be escaped.
std::string script_safe(const std::string& json) {
  std::string result;
  for (const char c : json) {
    if (c == '<')
      result += "\\u003c";
    else
      result += c;
  }
  return result;
}

// The template with the texts in place of these marks, which it has in this order.
std::string filled(const std::array<std::pair<std::string_view, std::string>, 2>& texts) {
  std::string page;
  std::size_t from = 0;
  for (const auto& [mark, text] : texts) {
    const std::size_t at = view_template.find(mark, from);
    core::require(at != std::string_view::npos, "view_page: the template has lost its marks");
    page += view_template.substr(from, at - from);
    page += text;
    from = at + mark.size();
  }
  page += view_template.substr(from);
  return page;
}

}  // namespace

std::string view_page(std::span<const PageDesign> designs, std::size_t first) {
  core::require(first < designs.size(), "view_page: needs the design it opens with");
  std::string data = "{\"first\":" + std::to_string(first) + ",\"designs\":[";
  for (const PageDesign& shown : designs)
    data += (&shown == &designs.front() ? "\n" : ",\n") + page_data(shown);
  data += "]}";
  return filled(
      {{{"@PICTURE@", picture_svg(designs[first].design)}, {"@DESIGNS@", script_safe(data)}}});
}

std::string view_page(const model::Design& design) {
  const PageDesign shown{.design = design};
  return view_page(std::span(&shown, 1));
}

}  // namespace tencer::app
