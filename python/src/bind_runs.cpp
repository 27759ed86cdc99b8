// The front door's calls: design, trade-off, feasibility, simulation.
#include <tencer/io/file.hpp>
#include <tencer/model/feasibility.hpp>
#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/feasible.hpp>
#include <tencer/pipeline/simulate.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "long_call.hpp"
#include "parts.hpp"

namespace tencer::python {
namespace {

pipeline::RunOptions run_options(std::stop_token stop, network::ProgressSink sink) {
  return {.stop = std::move(stop), .progress = std::move(sink)};
}

model::Design design(const model::Scene& scene, py::object progress) {
  return value_or_raise(long_call(std::move(progress), [&](auto stop, auto sink) {
    return pipeline::design(scene, run_options(stop, sink));
  }));
}

std::vector<model::Design> trade_off(const model::Scene& scene, py::object progress) {
  return value_or_raise(long_call(std::move(progress), [&](auto stop, auto sink) {
    return pipeline::trade_off(scene, run_options(stop, sink));
  }));
}

}  // namespace

void bind_runs(py::module_& module) {
  py::class_<Progress>(module, "Progress", "How far a search is.")
      .def_readonly("stage", &Progress::stage)
      .def_readonly("cables", &Progress::cables)
      .def_readonly("max_percent", &Progress::max_percent,
                    "Distance to the target, % of its bounding-box diagonal.")
      .def_readonly("seconds", &Progress::seconds, "Since the stage began.")
      .def("__repr__", [](const Progress& at) {
        return "<Progress " + at.stage + ": " + std::to_string(at.cables) + " cables>";
      });
  module.def(
      "write_file",
      [](const std::filesystem::path& path, const std::string& text) {
        if (const auto error = io::write_file(path, text)) throw BadInput{*error};
      },
      py::arg("path"), py::arg("text"));
  module.def("design", &design, py::arg("scene"), py::arg("progress") = py::none());
  module.def("trade_off", &trade_off, py::arg("scene"), py::arg("progress") = py::none());
}

}  // namespace tencer::python
