// A design as arrays and words.
#include <tencer/io/curve.hpp>
#include <tencer/io/design.hpp>
#include <tencer/io/export.hpp>
#include <tencer/io/trace.hpp>
#include <tencer/model/design.hpp>

#include "arrays.hpp"
#include "cable_rows.hpp"
#include "errors.hpp"
#include "parts.hpp"

namespace tencer::python {

namespace {

using model::Design;

void put_end(const springs::End& end, int& rod, int& anchor, double& s) {
  if (const auto* on_rod = std::get_if<springs::OnRod>(&end)) {
    rod = on_rod->rod;
    s = on_rod->s;
  } else {
    anchor = std::get<springs::AtAnchor>(end).anchor;
  }
}

py::array_t<CableRow> cables(const Design& design) {
  std::vector<CableRow> rows;
  for (std::size_t i = 0; i < design.structure.cables.size(); ++i)
    rows.push_back(
        row_of(design.structure.cables[i], design.built[i].length, design.built[i].tension));
  return table(rows);
}

std::vector<geometry::Polyline> pose_curves(const Design& design) {
  std::vector<geometry::Polyline> curves;
  for (std::size_t r = 0; r < design.pose.size(); ++r)
    curves.push_back(model::pose_curve(design, r));
  return curves;
}

// Ends of cables, 3 x 2 c, as (cables, 2, 3).
py::array_t<double> in_pairs(const Eigen::Matrix3Xd& ends) {
  py::array_t<double> points(
      {static_cast<py::ssize_t>(ends.cols() / 2), py::ssize_t{2}, py::ssize_t{3}});
  Eigen::Map<Eigen::Matrix3Xd>(points.mutable_data(), 3, ends.cols()) = ends;
  return points;
}

py::array_t<double> cable_points(const Design& design) {
  return in_pairs(model::cable_ends(design.structure, design.pose));
}

// As design.json has it.
std::optional<py::dict> at_least(const Design& design) {
  using namespace py::literals;
  if (!design.at_least) return std::nullopt;
  py::list stretches;
  for (const model::Arc& arc : design.at_least->stretches)
    stretches.append(py::dict("rod"_a = arc.rod, "from"_a = arc.from, "to"_a = arc.to));
  return py::dict("cables"_a = design.at_least->cables, "cable_ends"_a = design.at_least->ends,
                  "error_percent"_a = design.at_least->error_percent, "stretches"_a = stretches);
}

py::list snapshots(const model::StageRow& row) {
  using namespace py::literals;
  py::list shown;
  for (const model::Snapshot& one : row.snapshots) {
    py::list rods;
    for (const Eigen::Matrix3Xd& points : one.rods) rods.append(owned(points));
    shown.append(py::dict("max_percent"_a = one.max_percent, "rods"_a = rods,
                          "cable_points"_a = in_pairs(one.cable_ends),
                          "tensions"_a = owned(one.tensions)));
  }
  return shown;
}

py::list trace(const Design& design) {
  py::list rows;
  for (const model::StageRow& row : design.trace) {
    using namespace py::literals;
    rows.append(py::dict("stage"_a = row.stage, "seconds"_a = row.seconds, "cables"_a = row.cables,
                         "max_percent"_a = row.max_percent, "rms_percent"_a = row.rms_percent,
                         "solves"_a = row.solves, "iterations"_a = row.iterations,
                         "note"_a = row.note, "snapshots"_a = snapshots(row)));
  }
  return rows;
}

py::bytes export_bytes(const Design& design, const std::filesystem::path& path) {
  const auto format = io::export_format(path);
  if (!format)
    throw std::invalid_argument(path.string() + ": expected an ending among .json, .html, " +
                                std::string(io::export_endings()));
  return io::export_text(design, *format);
}

std::string json_of(const Design& design) {
  if (const auto wrong = io::design_problem("design", design)) throw BadInput{*wrong};
  return io::design_text(design);
}

}  // namespace

CableRow row_of(const springs::Cable& cable, double length, double tension) {
  CableRow row{.length = length,
               .tension = tension,
               .stiffness = cable.stiffness,
               .rest_length = cable.rest_length};
  put_end(cable.a, row.rod_a, row.anchor_a, row.s_a);
  put_end(cable.b, row.rod_b, row.anchor_b, row.s_b);
  return row;
}

void bind_design(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(CableRow, rod_a, anchor_a, s_a, rod_b, anchor_b, s_b, length, tension,
                       stiffness, rest_length);
  py::class_<Design>(module, "Design", py::dynamic_attr(),
                     "A structure with its cables, the pose in which it stands, and what is known "
                     "of it, in length_unit and force_unit. Arrays are read-only.")
      .def_readonly("name", &Design::name)
      .def_readonly("length_unit", &Design::length_unit)
      .def_readonly("force_unit", &Design::force_unit)
      .def_property_readonly(
          "status", [](const Design& design) { return io::status_name(design.status); },
          "\"complete\", \"tolerance-not-reached\" or \"interrupted\".")
      .def_property_readonly("complete", &Design::complete, "Whether it is all that was asked for.")
      .def_property_readonly(
          "shortfalls", [](const Design& design) { return model::shortfalls(design); },
          "Why it is not complete, a clause each.")
      .def_property_readonly(
          "poses", [](py::object self) { return views(self.cast<Design&>().pose, self); },
          "Where the rods rest: a view (n, 3) of each, lengths.")
      .def_property_readonly(
          "targets", [](py::object self) { return views(self.cast<Design&>().target, self); },
          "Where they were to be: a view (n, 3) of each, lengths.")
      .def_property_readonly(
          "anchors",
          [](py::object self) { return view(self.cast<Design&>().structure.anchors, self); },
          "Fixed points of cables, (k, 3), lengths.")
      .def_property_readonly(
          "closed",
          [](const Design& design) {
            std::vector<bool> closed;
            for (const der::Rod& rod : design.structure.rods) closed.push_back(rod.closed);
            return closed;
          },
          "Per rod, whether it is closed.")
      .def_property_readonly("curves", &pose_curves, "The poses as curves.")
      .def_property_readonly("cables", &cables, cable_columns)
      .def_property_readonly("cable_points", &cable_points,
                             "Where cables end in the pose, (cables, 2, 3), lengths.")
      .def_property_readonly(
          "structure", [](const Design& design) { return model::as_built(design); },
          "The rods, supports and loads with the cables as long as they are built: to be solved "
          "inextensible from structure.pose(poses).")
      .def_property_readonly(
          "max_percent",
          [](const Design& design) -> std::optional<double> {
            return design.error ? std::optional(design.error->max_percent) : std::nullopt;
          },
          "Largest distance of the pose from the target, % of the target's bounding-box diagonal.")
      .def_property_readonly(
          "rms_percent",
          [](const Design& design) -> std::optional<double> {
            return design.error ? std::optional(design.error->rms_percent) : std::nullopt;
          },
          "Its root mean square, likewise.")
      .def_property_readonly(
          "smallest_eigenvalue",
          [](const Design& design) -> std::optional<double> {
            return design.certificate ? std::optional(design.certificate->smallest_eigenvalue)
                                      : std::nullopt;
          },
          "Of the Hessian on motions that cables allow, in max EI / L^4 (a free straight rod has "
          "500.56).")
      .def_property_readonly(
          "stands",
          [](const Design& design) { return design.certificate && design.certificate->stable; },
          "Whether forces balance, no cable is slack, and every motion costs energy.")
      .def_property_readonly("at_least", &at_least,
                             "How many cables and ends of cables on rods are needed at least, "
                             "proven, as design.json has it (docs/how-few.md). None: nobody asked.")
      .def_property_readonly(
          "trace", &trace,
          "The record of error against run time: a dict a stage. Its snapshots are networks "
          "that it went through: a dict with max_percent, rods (n, 3), "
          "cable_points (cables, 2, 3) and tensions each.")
      .def("brief_report", &Design::brief_report, "One line.")
      .def("report", &Design::full_report, "What was asked for, what was found, and the stages.")
      .def("to_json", &json_of, "The text of design.json: what `tencer design` writes.")
      .def("export_bytes", &export_bytes, py::arg("path"),
           "The file of that ending for other programs: .obj, .vtp, .gltf, .glb, .dxf or .csv.")
      .def("pose_obj", [](const Design& design) { return io::obj_text(pose_curves(design)); })
      .def("trace_csv", [](const Design& design) { return io::trace_text(design.trace); })
      .def("__str__", &model::findings)
      .def("__repr__", [](const Design& design) {
        return "<Design " + design.name + ": " + design.brief_report() + ">";
      });
  module.def(
      "read_design",
      [](const std::filesystem::path& file) { return value_or_raise(io::read_design(file)); },
      py::arg("file"), "The design of a design.json, or of a published model of the paper.");
}

}  // namespace tencer::python
