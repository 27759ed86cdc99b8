#include <array>
#include <cmath>
#include <utility>

#include "design/design_json.hpp"

namespace tencer::io {
namespace {

using namespace model;
using Json = nlohmann::ordered_json;

Json to_json(const Eigen::VectorXd& numbers) {
  return Json(std::vector<double>(numbers.begin(), numbers.end()));
}

Json to_json(const Eigen::Vector3d& v) { return Json{v[0], v[1], v[2]}; }

Json to_json(const der::Shape& shape) {
  if (const auto* circle = std::get_if<der::Circle>(&shape))
    return Json{{"shape", "circle"}, {"radius", circle->radius}};
  if (const auto* tube = std::get_if<der::Tube>(&shape))
    return Json{{"shape", "tube"},
                {"outer_radius", tube->outer_radius},
                {"inner_radius", tube->inner_radius}};
  if (const auto* rectangle = std::get_if<der::Rectangle>(&shape))
    return Json{{"shape", "rectangle"}, {"width", rectangle->width}, {"height", rectangle->height}};
  return nullptr;
}

Json to_json(const Material& material) {
  Json result;
  result["name"] = material.name;
  result["youngs_modulus"] = material.youngs_modulus;
  if (material.density) result["density"] = *material.density;
  result["strain_limit"] = material.strain_limit;
  result["breaking_strain"] = material.breaking_strain;
  return result;
}

// Rod r of the design.
Json rod_to_json(const Design& design, std::size_t r) {
  const der::Rod& rod = design.structure.rods[r];
  Json result;
  result["closed"] = rod.closed;
  result["EA"] = rod.section.EA;
  result["EI"] = {rod.section.EI1, rod.section.EI2};
  result["GJ"] = rod.section.GJ;
  if (der::area(rod.section.shape)) result["section"] = to_json(rod.section.shape);
  if (!design.structure.materials.empty())
    result["material"] = to_json(design.structure.materials[r]);
  if (!design.strains.empty() && design.strains[r])
    result["bending_strain"] = Json{{"largest", design.strains[r]->strain},
                                    {"vertex", design.strains[r]->vertex},
                                    {"s", design.strains[r]->s},
                                    {"curvature", design.strains[r]->curvature}};
  result["rest_lengths"] = to_json(rod.rest_lengths);
  result["target"] = points_to_json(design.target[r]);
  result["pose"] = points_to_json(design.pose[r]);
  if (rod.closing_angle) result["closing_angle"] = *rod.closing_angle;
  if (rod.rest_curvature.size() > 0) {
    Json pairs = Json::array();
    for (const auto& bend : rod.rest_curvature.colwise()) pairs.push_back({bend[0], bend[1]});
    result["rest_curvature"] = pairs;
  }
  if (rod.rest_twist.size() > 0) result["rest_twist"] = to_json(rod.rest_twist);
  if (design.target_directors[r].size() > 0)
    result["target_directors"] = points_to_json(design.target_directors[r]);
  if (design.pose_directors[r].size() > 0)
    result["pose_directors"] = points_to_json(design.pose_directors[r]);
  return result;
}

Json to_json(const Pin& pin) {
  std::string axes;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (pin.axes[axis]) axes += axis_names[axis];
  return Json{{"rod", pin.rod}, {"vertex", pin.vertex}, {"axes", axes}};
}

Json to_json(const PointLoad& load) {
  return Json{{"rod", load.rod}, {"s", load.s}, {"force", to_json(load.force)}};
}

Json to_json(const LineLoad& load) {
  return Json{{"rod", load.rod}, {"force_per_length", to_json(load.force_per_length)}};
}

Json to_json(const View& view) {
  return {{"direction", to_json(view.direction)}, {"weight", view.weight}};
}

Json to_json(const springs::End& end) {
  if (const auto* anchor = std::get_if<springs::AtAnchor>(&end))
    return Json{{"anchor", anchor->anchor}};
  const auto& on_rod = std::get<springs::OnRod>(end);
  return Json{{"rod", on_rod.rod}, {"s", on_rod.s}};
}

Json cable_to_json(const springs::Cable& cable, const BuiltCable& built) {
  Json result;
  result["a"] = to_json(cable.a);
  result["b"] = to_json(cable.b);
  result["length"] = built.length;
  result["tension"] = built.tension;
  if (cable.stiffness != 0) {
    result["stiffness"] = cable.stiffness;
    result["rest_length"] = cable.rest_length;
  }
  return result;
}

Json to_json(const Certificate& certificate) {
  Json result;
  result["residual"] = certificate.residual;
  result["smallest_eigenvalue"] = certificate.smallest_eigenvalue;
  result["eigenvalue_unit"] = eigenvalue_unit;
  result["slack_cables"] = certificate.slack_cables;
  result["stable"] = certificate.stable;
  if (certificate.off_by_errors) result["off_by_errors"] = *certificate.off_by_errors;
  if (certificate.settles_from_target)
    result["settles_from_target"] = *certificate.settles_from_target;
  return result;
}

Json to_json(const Arc& stretch) {
  return {{"rod", stretch.rod}, {"from", stretch.from}, {"to", stretch.to}};
}

Json percent(double value) { return std::isnan(value) ? Json(nullptr) : Json(value); }

Json to_json(const StageRow& row) {
  Json result;
  result["stage"] = row.stage;
  result["seconds"] = row.seconds;
  result["cables"] = row.cables;
  result["max_percent"] = percent(row.max_percent);
  result["rms_percent"] = percent(row.rms_percent);
  result["equilibrium_solves"] = row.solves;
  result["newton_iterations"] = row.iterations;
  result["note"] = row.note;
  if (!row.snapshots.empty()) result["snapshots"] = snapshots_to_json(row.snapshots);
  return result;
}

template <class T>
Json list(const std::vector<T>& values) {
  Json result = Json::array();
  for (const T& value : values) result.push_back(to_json(value));
  return result;
}

}  // namespace

Json points_to_json(const Eigen::Matrix3Xd& points) {
  Json result = Json::array();
  for (const auto& point : points.colwise()) result.push_back({point[0], point[1], point[2]});
  return result;
}

Json at_least_to_json(const AtLeast& at_least) {
  return {{"cables", at_least.cables},
          {"cable_ends", at_least.ends},
          {"error_percent", at_least.error_percent},
          {"stretches", list(at_least.stretches)}};
}

const char* status_name(DesignStatus status) {
  switch (status) {
    case DesignStatus::complete:
      return "complete";
    case DesignStatus::tolerance_not_reached:
      return "tolerance-not-reached";
    case DesignStatus::interrupted:
      return "interrupted";
  }
  return "";
}

Json design_to_json(const Design& design) {
  const Structure& structure = design.structure;
  Json rods = Json::array();
  for (std::size_t r = 0; r < structure.rods.size(); ++r) rods.push_back(rod_to_json(design, r));
  Json cables = Json::array();
  for (std::size_t c = 0; c < structure.cables.size(); ++c)
    cables.push_back(cable_to_json(structure.cables[c], design.built[c]));
  Json result;
  result["schema"] = design_schema;
  result["name"] = design.name;
  result["status"] = status_name(design.status);
  if (const auto reasons = shortfalls(design); !reasons.empty()) result["shortfalls"] = reasons;
  result["length_unit"] = design.length_unit;
  result["force_unit"] = design.force_unit;
  result["rods"] = rods;
  result["anchors"] = points_to_json(structure.anchors);
  result["pinned"] = list(structure.pins);
  if (!structure.point_loads.empty()) result["point_loads"] = list(structure.point_loads);
  if (!structure.line_loads.empty()) result["line_loads"] = list(structure.line_loads);
  result["planar"] = structure.planar;
  if (!design.views.empty()) result["views"] = list(design.views);
  result["cables"] = cables;
  if (design.error)
    result["error"] = Json{{"max_percent", design.error->max_percent},
                           {"rms_percent", design.error->rms_percent}};
  if (design.at_least) result["at_least"] = at_least_to_json(*design.at_least);
  if (design.certificate) result["certificate"] = to_json(*design.certificate);
  if (design.check) result["check"] = check_to_json(*design.check, design);
  result["trace"] = list(design.trace);
  return result;
}

}  // namespace tencer::io
