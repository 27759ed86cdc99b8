#include <tencer/core/version.hpp>

#include "parts.hpp"

PYBIND11_MODULE(_core, module) {
  using namespace tencer::python;
  module.doc() = "The tencer library as it is in C++; use the package tencer.";
  module.attr("__version__") = TENCER_VERSION;
  bind_errors(module);
  bind_structure(module);
  bind_scene(module);
  bind_design(module);
  bind_runs(module);
  bind_actuate(module);
  bind_optimize(module);
  bind_search(module);
  bind_page(module);
}
