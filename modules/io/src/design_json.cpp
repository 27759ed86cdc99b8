#include "design_json.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "finish_curve.hpp"
#include "text.hpp"

namespace tencer::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* schema = "tencer-design/1";
constexpr std::array<std::pair<DesignStatus, std::string_view>, 3> statuses{
    {{DesignStatus::complete, "complete"},
     {DesignStatus::tolerance_not_reached, "tolerance-not-reached"},
     {DesignStatus::interrupted, "interrupted"}}};
constexpr std::string_view axis_names = "xyz";

// Other programs may add up the rest lengths in another order.
constexpr double arc_slack = 1e-9;

std::string optional_text(const JsonValue& object, std::string_view key) {
  return object.has(key) ? object[key].text() : std::string();
}

// ---- reading

void check_count(const JsonValue& value, long found, int expected, const std::string& what) {
  if (found != expected)
    value.fail("expected " + std::to_string(expected) + " " + what + ", found " +
               std::to_string(found));
}

// A rod's target or pose.
Eigen::Matrix3Xd read_shape(const JsonValue& value, bool closed) {
  Eigen::Matrix3Xd points = value.points();
  const int least = closed ? 3 : 2;
  if (points.cols() < least)
    value.fail("expected at least " + std::to_string(least) + " points, found " +
               std::to_string(points.cols()));
  if (const auto bad = bad_edge({points, closed}))
    value.items()[bad->from].fail(bad->no_length
                                      ? "zero-length edge: the next point is the same"
                                      : "the rod turns straight back here, which none can follow");
  return points;
}

// One direction an edge, none along it.
Eigen::Matrix3Xd read_directors(const JsonValue& value, const Eigen::Matrix3Xd& points, int edges) {
  constexpr double least = 1e-6;  // sine of the angle to the edge
  const Eigen::Matrix3Xd directors = value.points();
  check_count(value, directors.cols(), edges, "directions, one an edge");
  for (int j = 0; j < edges; ++j) {
    const Eigen::Vector3d t = (points.col((j + 1) % points.cols()) - points.col(j)).normalized();
    const Eigen::Vector3d m1 = directors.col(j);
    if (!(m1.cross(t).norm() > least * m1.norm()))
      value.items()[j].fail("expected a direction that is not along the edge");
  }
  return directors;
}

// What only some rods have.
void read_frames(const JsonValue& value, DesignRod& rod) {
  const int edges = static_cast<int>(rod.rest_lengths.size());
  const int bends = rod.closed ? edges : edges - 1;
  if (value.has("closing_angle")) {
    if (!rod.closed) value["closing_angle"].fail("belongs to closed rods");
    rod.closing_angle = value["closing_angle"].number();
  }
  if (value.has("rest_curvature")) {
    const std::vector<JsonValue> pairs = value["rest_curvature"].items();
    check_count(value["rest_curvature"], static_cast<long>(pairs.size()), bends, "pairs");
    rod.rest_curvature.resize(2, bends);
    for (int b = 0; b < bends; ++b) {
      check_count(pairs[b], pairs[b].numbers().size(), 2, "numbers");
      rod.rest_curvature.col(b) = pairs[b].numbers();
    }
  }
  if (value.has("rest_twist")) {
    rod.rest_twist = value["rest_twist"].numbers();
    check_count(value["rest_twist"], rod.rest_twist.size(), bends, "numbers");
  }
  if (value.has("target_directors"))
    rod.target_directors = read_directors(value["target_directors"], rod.target, edges);
  if (value.has("pose_directors"))
    rod.pose_directors = read_directors(value["pose_directors"], rod.pose, edges);
}

DesignRod read_rod(const JsonValue& value) {
  DesignRod rod;
  rod.closed = value["closed"].boolean();
  rod.EA = value["EA"].positive();
  const std::vector<JsonValue> bending = value["EI"].items();
  if (bending.size() != 2)
    value["EI"].fail("expected [a, b], found an array of " + std::to_string(bending.size()));
  rod.EI = {bending[0].positive(), bending[1].positive()};
  rod.GJ = value["GJ"].positive();
  rod.target = read_shape(value["target"], rod.closed);
  rod.pose = read_shape(value["pose"], rod.closed);
  const int n = static_cast<int>(rod.target.cols());
  check_count(value["pose"], rod.pose.cols(), n, "points, as in target");
  for (const JsonValue& item : value["rest_lengths"].items()) item.positive();
  rod.rest_lengths = value["rest_lengths"].numbers();
  check_count(value["rest_lengths"], rod.rest_lengths.size(), rod.closed ? n : n - 1, "numbers");
  read_frames(value, rod);
  return rod;
}

Pin read_pin(const JsonValue& value, const std::vector<DesignRod>& rods) {
  Pin pin;
  pin.rod = value["rod"].index(static_cast<int>(rods.size()), "rod");
  pin.vertex = value["vertex"].index(static_cast<int>(rods[pin.rod].target.cols()), "vertex");
  pin.axes = {false, false, false};
  const std::string axes = value["axes"].text();
  for (const char axis : axes) {
    const std::size_t at = axis_names.find(axis);
    if (at == std::string_view::npos)
      value["axes"].fail("expected letters of \"xyz\", found \"" + axes + "\"");
    pin.axes[at] = true;
  }
  if (axes.empty()) value["axes"].fail("expected letters of \"xyz\", found none");
  return pin;
}

// A place on a rod by its number and arc length.
double read_arc_length(const JsonValue& value, const DesignRod& rod) {
  const double s = value["s"].at_least_zero();
  if (s > rod.length() * (1.0 + arc_slack))
    value["s"].fail("expected an arc length from 0 to " + to_text(rod.length()) + ", found " +
                    to_text(s));
  return s;
}

PointLoad read_point_load(const JsonValue& value, const std::vector<DesignRod>& rods) {
  PointLoad load;
  load.rod = value["rod"].index(static_cast<int>(rods.size()), "rod");
  load.s = read_arc_length(value, rods[load.rod]);
  load.force = value["force"].point();
  return load;
}

LineLoad read_line_load(const JsonValue& value, const std::vector<DesignRod>& rods) {
  return {.rod = value["rod"].index(static_cast<int>(rods.size()), "rod"),
          .force_per_length = value["force_per_length"].point()};
}

CableEnd read_end(const JsonValue& value, const Design& design) {
  if (value.has("rod") == value.has("anchor"))
    value.fail("expected {\"rod\", \"s\"} or {\"anchor\"}");
  CableEnd end;
  if (value.has("anchor")) {
    end.anchor = value["anchor"].index(static_cast<int>(design.anchors.cols()), "anchor");
    return end;
  }
  end.rod = value["rod"].index(static_cast<int>(design.rods.size()), "rod");
  end.s = read_arc_length(value, design.rods[end.rod]);
  return end;
}

DesignCable read_cable(const JsonValue& value, const Design& design) {
  DesignCable cable;
  cable.a = read_end(value["a"], design);
  cable.b = read_end(value["b"], design);
  if (cable.a.anchor >= 0 && cable.b.anchor >= 0)
    value.fail("a cable from anchor to anchor holds no rod");
  cable.length = value["length"].positive();
  cable.tension = value["tension"].number();
  if (value.has("stiffness") != value.has("rest_length"))
    value.fail("stiffness and rest_length belong together: give both or neither");
  if (value.has("stiffness")) {
    cable.stiffness = value["stiffness"].positive();
    cable.rest_length = value["rest_length"].at_least_zero();
  }
  return cable;
}

Certificate read_certificate(const JsonValue& value) {
  Certificate certificate{.residual = value["residual"].number(),
                          .smallest_eigenvalue = value["smallest_eigenvalue"].number(),
                          .eigenvalue_unit = optional_text(value, "eigenvalue_unit"),
                          .slack_cables = value["slack_cables"].integer(0),
                          .stable = value["stable"].boolean()};
  if (value.has("settles_from_target"))
    certificate.settles_from_target = value["settles_from_target"].boolean();
  return certificate;
}

double read_percent(const JsonValue& value) {
  return value.raw().is_null() ? std::numeric_limits<double>::quiet_NaN() : value.at_least_zero();
}

TraceRow read_trace_row(const JsonValue& value) {
  TraceRow row;
  row.stage = value["stage"].text();
  row.seconds = value["seconds"].at_least_zero();
  row.cables = value["cables"].integer(0);
  row.max_percent = read_percent(value["max_percent"]);
  row.rms_percent = read_percent(value["rms_percent"]);
  if (value.has("equilibrium_solves"))
    row.equilibrium_solves = value["equilibrium_solves"].integer(0);
  if (value.has("newton_iterations")) row.newton_iterations = value["newton_iterations"].integer(0);
  row.note = optional_text(value, "note");
  return row;
}

DesignStatus read_status(const JsonValue& value) {
  const std::string text = value.text();
  for (const auto& [status, name] : statuses)
    if (text == name) return status;
  value.fail("expected \"complete\", \"tolerance-not-reached\" or \"interrupted\", found \"" +
             text + "\"");
}

// ---- writing

Json to_json(const Eigen::Matrix3Xd& points) {
  Json result = Json::array();
  for (const auto& point : points.colwise()) result.push_back({point[0], point[1], point[2]});
  return result;
}

Json to_json(const Eigen::VectorXd& numbers) {
  return Json(std::vector<double>(numbers.begin(), numbers.end()));
}

Json to_json(const Eigen::Vector3d& v) { return Json{v[0], v[1], v[2]}; }

Json to_json(const DesignRod& rod) {
  Json result;
  result["closed"] = rod.closed;
  result["EA"] = rod.EA;
  result["EI"] = {rod.EI[0], rod.EI[1]};
  result["GJ"] = rod.GJ;
  result["rest_lengths"] = to_json(rod.rest_lengths);
  result["target"] = to_json(rod.target);
  result["pose"] = to_json(rod.pose);
  if (rod.closing_angle) result["closing_angle"] = *rod.closing_angle;
  if (rod.rest_curvature.size() > 0) {
    Json pairs = Json::array();
    for (const auto& bend : rod.rest_curvature.colwise()) pairs.push_back({bend[0], bend[1]});
    result["rest_curvature"] = pairs;
  }
  if (rod.rest_twist.size() > 0) result["rest_twist"] = to_json(rod.rest_twist);
  if (rod.target_directors.size() > 0) result["target_directors"] = to_json(rod.target_directors);
  if (rod.pose_directors.size() > 0) result["pose_directors"] = to_json(rod.pose_directors);
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

Json to_json(const CableEnd& end) {
  Json result;
  if (end.rod >= 0 || end.anchor < 0) {
    result["rod"] = end.rod;
    result["s"] = end.s;
  }
  if (end.anchor >= 0) result["anchor"] = end.anchor;
  return result;
}

Json to_json(const DesignCable& cable) {
  Json result;
  result["a"] = to_json(cable.a);
  result["b"] = to_json(cable.b);
  result["length"] = cable.length;
  result["tension"] = cable.tension;
  if (cable.stiffness) result["stiffness"] = *cable.stiffness;
  if (cable.rest_length) result["rest_length"] = *cable.rest_length;
  return result;
}

Json to_json(const Certificate& certificate) {
  Json result;
  result["residual"] = certificate.residual;
  result["smallest_eigenvalue"] = certificate.smallest_eigenvalue;
  result["eigenvalue_unit"] = certificate.eigenvalue_unit;
  result["slack_cables"] = certificate.slack_cables;
  result["stable"] = certificate.stable;
  if (certificate.settles_from_target)
    result["settles_from_target"] = *certificate.settles_from_target;
  return result;
}

Json percent(double value) { return std::isnan(value) ? Json(nullptr) : Json(value); }

Json to_json(const TraceRow& row) {
  Json result;
  result["stage"] = row.stage;
  result["seconds"] = row.seconds;
  result["cables"] = row.cables;
  result["max_percent"] = percent(row.max_percent);
  result["rms_percent"] = percent(row.rms_percent);
  result["equilibrium_solves"] = row.equilibrium_solves;
  result["newton_iterations"] = row.newton_iterations;
  result["note"] = row.note;
  return result;
}

template <class T>
Json list(const std::vector<T>& values) {
  Json result = Json::array();
  for (const T& value : values) result.push_back(to_json(value));
  return result;
}

}  // namespace

const char* status_name(DesignStatus status) {
  for (const auto& [value, name] : statuses)
    if (value == status) return name.data();
  return "";
}

Design design_from_json(const JsonValue& root) {
  Design design;
  if (!root.raw().is_object()) root.fail("is not a design: expected an object");
  const std::string found = root["schema"].text();
  if (found != schema)
    root["schema"].fail("expected \"" + std::string(schema) + "\", found \"" + found + "\"");
  design.name = optional_text(root, "name");
  if (root.has("status")) design.status = read_status(root["status"]);
  design.length_unit = root["length_unit"].text();
  design.force_unit = root["force_unit"].text();
  for (const JsonValue& rod : root["rods"].items()) design.rods.push_back(read_rod(rod));
  if (design.rods.empty()) root["rods"].fail("expected at least one rod");
  if (root.has("anchors")) design.anchors = root["anchors"].points();
  if (root.has("pinned"))
    for (const JsonValue& pin : root["pinned"].items())
      design.pinned.push_back(read_pin(pin, design.rods));
  if (root.has("point_loads"))
    for (const JsonValue& load : root["point_loads"].items())
      design.point_loads.push_back(read_point_load(load, design.rods));
  if (root.has("line_loads"))
    for (const JsonValue& load : root["line_loads"].items())
      design.line_loads.push_back(read_line_load(load, design.rods));
  if (root.has("planar")) design.planar = root["planar"].boolean();
  for (const JsonValue& cable : root["cables"].items())
    design.cables.push_back(read_cable(cable, design));
  if (root.has("error")) {
    const JsonValue error = root["error"];
    design.error =
        DesignError{error["max_percent"].at_least_zero(), error["rms_percent"].at_least_zero()};
  }
  if (root.has("certificate")) design.certificate = read_certificate(root["certificate"]);
  if (root.has("trace"))
    for (const JsonValue& row : root["trace"].items()) design.trace.push_back(read_trace_row(row));
  return design;
}

Json design_to_json(const Design& design) {
  Json result;
  result["schema"] = schema;
  result["name"] = design.name;
  result["status"] = status_name(design.status);
  result["length_unit"] = design.length_unit;
  result["force_unit"] = design.force_unit;
  result["rods"] = list(design.rods);
  result["anchors"] = to_json(design.anchors);
  result["pinned"] = list(design.pinned);
  if (!design.point_loads.empty()) result["point_loads"] = list(design.point_loads);
  if (!design.line_loads.empty()) result["line_loads"] = list(design.line_loads);
  result["planar"] = design.planar;
  result["cables"] = list(design.cables);
  if (design.error)
    result["error"] = Json{{"max_percent", design.error->max_percent},
                           {"rms_percent", design.error->rms_percent}};
  if (design.certificate) result["certificate"] = to_json(*design.certificate);
  result["trace"] = list(design.trace);
  return result;
}

}  // namespace tencer::io
