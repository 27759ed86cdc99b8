// Pages, pictures and words as the program has them; only where its views are built.
#include "parts.hpp"

#ifdef TENCER_WITH_PAGE
#include <tencer/io/file.hpp>
#include <tencer/model/design.hpp>

#include "actuate/actuate.hpp"
#include "actuate/words.hpp"
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

void write_actuation(const rehearsal::Actuated& actuation, const std::filesystem::path& folder) {
  if (const auto wrong = io::folder_problem(folder)) throw BadInput{*wrong};
  if (const auto wrong = io::write_files(folder, app::actuation_files(actuation)))
    throw BadInput{*wrong};
}

}  // namespace
#endif

void bind_page([[maybe_unused]] py::module_& module) {
#ifdef TENCER_WITH_PAGE
  module.def(
      "page", [](const model::Design& design) { return app::view_page(design); }, py::arg("design"),
      "The text of view.html.");
  module.def(
      "page", [](const rehearsal::Actuated& actuation) { return app::view_page(actuation); },
      py::arg("actuation"), "The text of view.html, which plays the poses.");
  module.def(
      "actuation_report",
      [](const rehearsal::Actuated& actuation) { return app::in_words(actuation); },
      py::arg("actuation"), "What happened, in words.");
  module.def("write_actuation", &write_actuation, py::arg("actuation"), py::arg("folder"),
             "What `tencer actuate` writes into the folder.");
  module.def("picture_bytes", &picture_bytes, py::arg("design"), py::arg("path"), py::arg("views"),
             py::arg("caption"), py::arg("numbers"),
             "A picture, in the format of the path's ending; writes nothing.");
#endif
}

}  // namespace tencer::python
