// Targets and scenes: curves from arrays, files and families, and the keys of a scene file.
#include <algorithm>
#include <optional>
#include <sstream>
#include <tencer/curves/families.hpp>
#include <tencer/io/curve.hpp>
#include <tencer/io/scene.hpp>
#include <tencer/model/material.hpp>
#include <tencer/model/resolution.hpp>
#include <tencer/model/scene.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "parts.hpp"

namespace tencer::python {
namespace {

using geometry::Polyline;

Polyline curve_of(const Given& points, std::optional<bool> closed, const std::string& name) {
  const auto listed = points_of(points, name);
  return value_or_raise(io::listed_curve(listed, closed, name)).curves.front();
}

std::string describe(const Polyline& curve) {
  std::ostringstream text;
  text << "<Curve: " << curve.vertices() << " vertices, " << (curve.closed ? "closed" : "open")
       << ", " << geometry::edge_lengths(curve).sum() << " long>";
  return text.str();
}

py::dict family_table() {
  py::dict families;
  for (const curves::Family& family : curves::families()) {
    py::dict parameters;
    for (const curves::FamilyParameter& parameter : family.parameters)
      parameters[py::str(std::string(parameter.name))] = parameter.standard;
    families[py::str(family.name)] = parameters;
  }
  return families;
}

model::Scene scene(const std::optional<std::filesystem::path>& file, const std::string& keys,
                   std::vector<Polyline> curves, std::vector<model::Design> designs,
                   const std::string& name, double resolution) {
  const io::SceneKeys said{keys, std::move(curves), std::move(designs)};
  const py::gil_scoped_release free;
  const model::Scene made = !file          ? value_or_raise(io::scene_of_keys(said, name))
                            : keys.empty() ? value_or_raise(io::read_any_scene(*file))
                                           : value_or_raise(io::scene_with_keys(*file, said));
  return model::at_resolution(made, resolution);
}

}  // namespace

void bind_scene(py::module_& module) {
  py::class_<Polyline>(module, "Curve", "A target curve.")
      .def(
          py::init(&curve_of), py::arg("points"), py::arg("closed") = py::none(),
          py::arg("name") = "points",
          "The curve through points, an array (n, 3). It is closed when its last point repeats its "
          "first, or when `closed` says so.")
      .def_property_readonly(
          "points", [](py::object self) { return view(self.cast<Polyline&>().points, self); },
          "The vertices, (n, 3), read-only; a closed curve does not repeat its first.")
      .def_readonly("closed", &Polyline::closed)
      .def("__len__", &Polyline::vertices)
      .def("__repr__", &describe);

  py::class_<model::Scene>(
      module, "Scene", "What to design: targets, rods, supports, and how. tencer.scene makes it.")
      .def_readonly("name", &model::Scene::name)
      .def_readonly("length_unit", &model::Scene::length_unit)
      .def_readonly("force_unit", &model::Scene::force_unit)
      .def_readonly("notes", &model::Scene::notes,
                    "What was taken otherwise than it was given, in words.")
      .def_property_readonly("curves", &model::target_curves, "The targets, a Curve per rod.")
      .def("__str__", &model::in_one_line)
      .def("__repr__", [](const model::Scene& made) {
        return "<Scene " + made.name + ": " + model::in_one_line(made) + ">";
      });

  module.def("scene", &scene, py::arg("file"), py::arg("keys"), py::arg("curves"),
             py::arg("designs"), py::arg("name"), py::arg("resolution"));
  module.def(
      "read_curves",
      [](const std::filesystem::path& file) { return value_or_raise(io::read_curves(file)); },
      py::arg("file"),
      "The curves of a file: OBJ, CSV, JSON, VECT, SVG, DXF or a design (docs/curves.md).");
  module.def("families", &family_table,
             "The built-in families of curves: {name: {parameter: default}}.");
}

}  // namespace tencer::python
