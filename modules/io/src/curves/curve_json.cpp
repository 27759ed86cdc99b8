#include "curves/curve_json.hpp"

#include <algorithm>
#include <array>

#include "curves/finish_curve.hpp"
#include "design/design_json.hpp"
#include "design/json_value.hpp"
#include "text/bad_input.hpp"
#include "text/length_unit.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

// The words for a list of points, and all that an object of a curve may have.
constexpr std::array<std::string_view, 4> point_keys{"points", "vertices", "positions", "coords"};
constexpr std::array<std::string_view, 11> curve_keys{
    "closed", "points", "vertices", "positions", "coords", "x", "y", "z", "name", "unit", "units"};

bool has_axes(const JsonValue& value) {
  return value.raw().is_object() && value.has("x") && value.has("y");
}

bool is_pair(const JsonValue& value) { return value.raw().is_array() && value.raw().size() == 2; }

// [x, y, z] or {"x", "y", "z"}; in the plane z = 0 [x, y] or {"x", "y"}.
Eigen::Vector3d read_point(const JsonValue& value, bool planar) {
  if (has_axes(value))
    return {value["x"].number(), value["y"].number(), value.has("z") ? value["z"].number() : 0.0};
  if (!planar) return value.point();
  if (!is_pair(value)) value.fail("expected a point [x, y], like the first");
  const auto two = value.items();
  return {two[0].number(), two[1].number(), 0.0};
}

void add_points(const JsonValue& list, std::optional<bool> closed, CurveFile& result) {
  const std::vector<JsonValue> items = list.items();
  ListedCurve curve;
  for (const JsonValue& item : items)
    curve.points.push_back(read_point(item, is_pair(items.front())));
  curve.closed = closed;
  curve.where = list.where();
  curve.where_of = [&](int i) { return items[i].where(); };
  curve.name_of = [](int i) { return "point " + std::to_string(i); };
  finish_curve(curve, result);
}

// {"x": [...], "y": [...], "z": [...]}.
void add_columns(const JsonValue& value, std::optional<bool> closed, CurveFile& result) {
  const Eigen::VectorXd x = value["x"].numbers();
  const Eigen::VectorXd y = value["y"].numbers();
  const Eigen::VectorXd z = value.has("z") ? value["z"].numbers() : Eigen::VectorXd::Zero(x.size());
  if (y.size() != x.size() || z.size() != x.size())
    value.fail("x, y and z must be equally many; found " + std::to_string(x.size()) + ", " +
               std::to_string(y.size()) + " and " + std::to_string(z.size()));
  ListedCurve curve;
  for (Eigen::Index i = 0; i < x.size(); ++i) curve.points.emplace_back(x[i], y[i], z[i]);
  curve.closed = closed;
  curve.where = value.where();
  curve.where_of = [&](int) { return value.where(); };
  curve.name_of = [](int i) { return "point " + std::to_string(i); };
  finish_curve(curve, result);
}

// A misspelt "closed" must not turn a ring into an open rod.
void check_keys(const JsonValue& curve) {
  for (const auto& [key, value] : curve.raw().items())
    if (std::ranges::find(curve_keys, key) == curve_keys.end())
      curve.fail("unknown key " + key + "; " + suggestion(key, curve_keys));
}

void add_object(const JsonValue& curve, CurveFile& result) {
  std::optional<bool> closed;
  if (curve.has("closed")) closed = curve["closed"].boolean();
  check_keys(curve);
  if (has_axes(curve)) return add_columns(curve, closed, result);
  for (const std::string_view key : point_keys)
    if (curve.has(key)) return add_points(curve[key], closed, result);
  add_points(curve["points"], closed, result);
}

bool is_point(const nlohmann::json& value) {
  if (value.is_object()) return value.contains("x") && value["x"].is_number();
  return value.is_array() && !value.empty() && value[0].is_number();
}

// An array is a curve of points, or several of these, or of objects.
void add_array(const JsonValue& list, CurveFile& result) {
  const nlohmann::json& raw = list.raw();
  const bool objects = !raw.empty() && raw[0].is_object() && !is_point(raw[0]);
  const bool arrays = !raw.empty() && raw[0].is_array() && !raw[0].empty() && !is_point(raw[0]);
  if (!objects && !arrays) return add_points(list, std::nullopt, result);
  for (const JsonValue& item : list.items())
    if (item.raw().is_array())
      add_points(item, std::nullopt, result);
    else
      add_object(item, result);
}

void refuse_foreign(const JsonValue& root) {
  if (root.has("type") && (root.has("features") || root.has("coordinates") || root.has("geometry")))
    root.fail(
        "is GeoJSON, a map in degrees; project it to metres and save the points as CSV, x,y,z a "
        "line");
}

void read_unit(const JsonValue& root, CurveFile& result) {
  for (const char* key : {"unit", "units", "length_unit"}) {
    if (!root.has(key)) continue;
    const auto unit = unit_meant(root[key].text());
    if (!unit) root[key].fail("expected mm, cm, m, in or ft, found \"" + root[key].text() + "\"");
    result.length_unit = *unit;
    return;
  }
}

CurveFile targets(const model::Design& design) {
  CurveFile result;
  for (std::size_t r = 0; r < design.target.size(); ++r)
    result.curves.push_back({design.target[r], design.structure.rods[r].closed});
  return result;
}

}  // namespace

CurveFile parse_curve_json(std::string_view text, const std::string& file) {
  const nlohmann::json content = JsonValue::parse(text, file);
  const JsonValue root(content, file);
  if (is_design(content)) return targets(any_design(root, file));
  CurveFile result;
  if (content.is_array()) {
    add_array(root, result);
    return result;
  }
  if (!content.is_object())
    root.fail("expected {\"curves\": [...]} or an array of points [x, y, z]");
  refuse_foreign(root);
  if (root.has("curves"))
    for (const JsonValue& curve : root["curves"].items())
      if (curve.raw().is_array())
        add_points(curve, std::nullopt, result);
      else
        add_object(curve, result);
  else if (has_axes(root) ||
           std::ranges::any_of(point_keys, [&](auto key) { return root.has(key); }))
    add_object(root, result);
  else
    root.fail("the key \"curves\" is missing");
  if (result.curves.empty()) root["curves"].fail("holds no curves");
  read_unit(root, result);
  return result;
}

}  // namespace tencer::io
