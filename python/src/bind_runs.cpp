// The front door's calls: design, trade-off, feasibility, simulation.
#include <tencer/io/check.hpp>
#include <tencer/io/feasibility.hpp>
#include <tencer/io/file.hpp>
#include <tencer/model/feasibility.hpp>
#include <tencer/pipeline/check.hpp>
#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/feasible.hpp>
#include <tencer/pipeline/simulate.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "long_call.hpp"
#include "parts.hpp"

namespace tencer::python {
namespace {

pipeline::RunOptions run_options(LongCall& call) {
  return {.stop = call.token(), .progress = call.sink(), .log = call.log()};
}

model::Design design(const model::Scene& scene, py::object progress) {
  return value_or_raise(long_call(std::move(progress), [&](LongCall& call) {
    return pipeline::design(scene, run_options(call));
  }));
}

std::vector<model::Design> trade_off(const model::Scene& scene, py::object progress) {
  return value_or_raise(long_call(std::move(progress), [&](LongCall& call) {
    return pipeline::trade_off(scene, run_options(call));
  }));
}

// (the design as it comes to rest, the check as JSON, and in words)
py::tuple check(const model::Design& design, double length_error_mm, double attachment_error_mm,
                const std::optional<std::string>& max_deviation, int draws, bool repair) {
  model::Allowance deviation;
  if (max_deviation) {
    const auto read = model::read_allowance(*max_deviation);
    if (!read)
      throw std::invalid_argument("max_deviation: expected \"2 mm\" or \"1 %\", found \"" +
                                  *max_deviation + '"');
    deviation = *read;
  }
  const auto checked = value_or_raise(long_call(py::none(), [&](LongCall& call) {
    return pipeline::check(design, {.length_error_mm = length_error_mm,
                                    .attachment_error_mm = attachment_error_mm,
                                    .max_deviation = deviation,
                                    .draws = draws,
                                    .repair = repair,
                                    .stop = call.token()});
  }));
  return py::make_tuple(checked.design, io::check_text(checked.design, checked.check),
                        model::report(checked.check, model::terms_of(checked.design)));
}

pipeline::Simulation simulate(const model::Design& design, bool from_target, bool springs,
                              int refine) {
  return value_or_raise(long_call(py::none(), [&](LongCall& call) {
    return pipeline::simulate(
        design, {.start = from_target ? pipeline::Start::target : pipeline::Start::pose,
                 .cables = springs ? pipeline::Cables::springs : pipeline::Cables::inextensible,
                 .refine = refine,
                 .solve = {.stop = call.token()}});
  }));
}

// (as JSON, and in words)
py::tuple feasible(const model::Scene& scene) {
  const auto found = value_or_raise(long_call(py::none(), [&](LongCall& call) {
    return pipeline::feasible(scene, {.stop = call.token()});
  }));
  return py::make_tuple(io::feasibility_text(found), model::report(found));
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
      [](const std::filesystem::path& path, const std::string& content) {
        if (const auto error = io::write_file(path, content)) throw BadInput{*error};
      },
      py::arg("path"), py::arg("content"));
  module.def("design", &design, py::arg("scene"), py::arg("progress") = py::none());
  module.def("check", &check, py::arg("design"), py::arg("length_error_mm"),
             py::arg("attachment_error_mm"), py::arg("max_deviation"), py::arg("draws"),
             py::arg("repair"));
  module.def("feasible", &feasible, py::arg("scene"));
  py::class_<pipeline::Simulation>(module, "Simulation", "Where a design comes to rest.")
      .def_readonly("design", &pipeline::Simulation::design,
                    "The design with the pose, tensions and error found.")
      .def_property_readonly("stays", &pipeline::Simulation::stays,
                             "Whether it rests within 1 % of the target's size from its pose.")
      .def_property_readonly("usable", &pipeline::Simulation::usable, "Whether it comes to rest.")
      .def_property_readonly(
          "reason",
          [](const pipeline::Simulation& self) { return equilibrium::describe(self.reason); })
      .def_readonly("moved_percent", &pipeline::Simulation::moved_percent,
                    "How far a vertex moved from the pose, % of the target's diagonal.")
      .def_readonly("residual", &pipeline::Simulation::residual)
      .def_readonly("iterations", &pipeline::Simulation::iterations);
  module.def("simulate", &simulate, py::arg("design"), py::arg("from_target"), py::arg("springs"),
             py::arg("refine"));
  module.def("trade_off", &trade_off, py::arg("scene"), py::arg("progress") = py::none());
}

}  // namespace tencer::python
