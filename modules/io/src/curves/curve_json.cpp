#include "curves/curve_json.hpp"

#include <array>

#include "curves/finish_curve.hpp"
#include "design/design_json.hpp"
#include "design/json_value.hpp"
#include "text/bad_input.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

geometry::Polyline parse_points(const JsonValue& points, std::optional<bool> closed,
                                std::vector<std::string>& notes) {
  const std::vector<JsonValue> items = points.items();
  ListedCurve curve;
  for (const JsonValue& item : items) {
    if (item.raw().is_object())
      item.fail(
          "expected a point [x, y, z], found an object; write each point {\"x\": 1, \"y\": 2, "
          "\"z\": 3} as [1, 2, 3]");
    curve.points.push_back(item.point());
  }
  curve.closed = closed;
  curve.where = points.where();
  curve.where_of = [&](int i) { return items[i].where(); };
  curve.name_of = [](int i) { return "point " + std::to_string(i); };
  return finish_curve(curve, notes);
}

// A misspelt "closed" must not turn a ring into an open rod.
void check_keys(const JsonValue& curve) {
  static constexpr std::array<std::string_view, 2> known{"closed", "points"};
  for (const auto& [key, value] : curve.raw().items())
    if (key != known[0] && key != known[1])
      curve.fail("unknown key " + key + "; " + suggestion(key, known));
}

}  // namespace

CurveFile parse_curve_json(std::string_view text, const std::string& file) {
  const nlohmann::json content = JsonValue::parse(text, file);
  const JsonValue root(content, file);
  CurveFile result;
  if (is_design(content)) {
    const model::Design design = any_design(root, file);
    for (std::size_t r = 0; r < design.target.size(); ++r)
      result.curves.push_back({design.target[r], design.structure.rods[r].closed});
    return result;
  }
  if (content.is_array()) {
    result.curves.push_back(parse_points(root, std::nullopt, result.notes));
    return result;
  }
  if (!content.is_object())
    root.fail("expected {\"curves\": [...]} or an array of points [x, y, z]");
  const JsonValue list = root["curves"];
  for (const JsonValue& curve : list.items()) {
    std::optional<bool> closed;
    if (curve.has("closed")) closed = curve["closed"].boolean();
    check_keys(curve);
    result.curves.push_back(parse_points(curve["points"], closed, result.notes));
  }
  if (result.curves.empty()) list.fail("holds no curves");
  return result;
}

}  // namespace tencer::io
