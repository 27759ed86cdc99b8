// The page of a design, as the program writes it; only where the program's views are built.
#include "parts.hpp"

#ifdef TENCER_WITH_PAGE
#include <tencer/model/design.hpp>

#include "view_page.hpp"
#endif

namespace tencer::python {

void bind_page([[maybe_unused]] py::module_& module) {
#ifdef TENCER_WITH_PAGE
  module.def(
      "page", [](const model::Design& design) { return app::view_page(design); }, py::arg("design"),
      "The text of view.html.");
#endif
}

}  // namespace tencer::python
