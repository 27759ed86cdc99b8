// The page and pictures of a design, as the program makes them; only where its views are built.
#include "parts.hpp"

#ifdef TENCER_WITH_PAGE
#include <tencer/model/design.hpp>

#include "drawing/picture.hpp"
#include "errors.hpp"
#include "view_page.hpp"
#endif

namespace tencer::python {

#ifdef TENCER_WITH_PAGE
namespace {

std::string all_views() {
  std::string all;
  for (const std::string& name : app::view_names()) all += (all.empty() ? "" : ", ") + name;
  return all;
}

py::bytes picture_bytes(const model::Design& design, const std::filesystem::path& path,
                        const std::vector<std::string>& views, const std::string& caption,
                        bool numbers) {
  if (const auto wrong = app::picture_problem(path)) throw BadInput{*wrong};
  app::PictureOptions options{.caption = caption, .numbers = numbers};
  for (const std::string& name : views) {
    const auto view = app::view_named(name);
    if (!view) throw BadInput{{"views", "there is no '" + name + "'; use " + all_views()}};
    options.views.push_back(*view);
  }
  return app::picture(design, *app::picture_format(path), options);
}

}  // namespace
#endif

void bind_page([[maybe_unused]] py::module_& module) {
#ifdef TENCER_WITH_PAGE
  module.def(
      "page", [](const model::Design& design) { return app::view_page(design); }, py::arg("design"),
      "The text of view.html.");
  module.def("picture_bytes", &picture_bytes, py::arg("design"), py::arg("path"), py::arg("views"),
             py::arg("caption"), py::arg("numbers"),
             "A picture, in the format of the path's ending; writes nothing.");
#endif
}

}  // namespace tencer::python
