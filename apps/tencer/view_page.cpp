#include "view_page.hpp"

#include <tencer/core/error.hpp>

#include "picture.hpp"
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

}  // namespace

std::string view_page(const model::Design& design) {
  constexpr std::string_view picture_mark = "@PICTURE@";
  constexpr std::string_view design_mark = "@DESIGN@";
  const auto picture_at = view_template.find(picture_mark);
  const auto design_at = view_template.find(design_mark);
  core::require(picture_at < design_at && design_at != std::string_view::npos,
                "view_page: the template has lost its marks");
  std::string page(view_template.substr(0, picture_at));
  page += picture_svg(design);
  const auto after_picture = picture_at + picture_mark.size();
  page += view_template.substr(after_picture, design_at - after_picture);
  page += script_safe(io::design_text(design));
  page += view_template.substr(design_at + design_mark.size());
  return page;
}

}  // namespace tencer::app
