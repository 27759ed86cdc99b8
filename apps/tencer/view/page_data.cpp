#include "view/page_data.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tencer/certify/closest.hpp>
#include <tencer/fabricate/crossings.hpp>
#include <tencer/io/design.hpp>
#include <tencer/model/material.hpp>
#include <tencer/model/units.hpp>
#include <tencer/model/vertex_fields.hpp>
#include <tencer/model/words.hpp>
#include <tencer/pipeline/shoves.hpp>
#include <tencer/pipeline/vibrations.hpp>
#include <vector>

#include "drawing/axes.hpp"

namespace tencer::app {
namespace {

using Json = nlohmann::ordered_json;

// Five digits are more than anyone sees, and a third of the bytes.
Json seen(double value) {
  if (!std::isfinite(value)) return nullptr;
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 5);
  double rounded = value;
  std::from_chars(text.data(), end.ptr, rounded);
  return rounded;
}

Json list(const Eigen::VectorXd& values) {
  Json result = Json::array();
  for (const double value : values) result.push_back(seen(value));
  return result;
}

Json points(const Eigen::Matrix3Xd& columns) {
  Json result = Json::array();
  for (const auto& column : columns.colwise())
    result.push_back({seen(column[0]), seen(column[1]), seen(column[2])});
  return result;
}

bool is_known(const std::string& length_unit) {
  return std::ranges::count(model::length_units(), length_unit) > 0;
}

Json rod_json(const model::Design& design, std::size_t r, const model::VertexFields& fields) {
  const der::Rod& rod = design.structure.rods[r];
  const der::Shape& shape = rod.section.shape;
  Json result{{"section_words", nullptr},
              {"material_words", nullptr},
              {"half_sizes", nullptr},
              {"grams", nullptr}};
  if (const auto half = der::half_sizes(shape)) {
    result["section_words"] = model::in_words(shape, design.length_unit);
    result["half_sizes"] = {half->along_m1, half->along_m2};
  }
  if (!design.structure.materials.empty()) {
    const model::Material& material = design.structure.materials[r];
    result["material_words"] = model::in_words(material);
    if (is_known(design.length_unit))
      if (const auto mass = model::mass_per_length(material, shape, design.length_unit))
        result["grams"] = seen(1e3 * *mass * model::metres(design.length_unit) * rod.length());
  }
  result["deviation"] = points(fields.deviation);
  result["curvature"] = list(fields.curvature);
  result["strain"] = fields.strain ? list(*fields.strain) : Json(nullptr);
  result["tension"] = list(fields.tension);
  return result;
}

// All strands of rods, and of the other kinds the one pair that is nearest.
Json closest_json(const model::Design& design) {
  const model::Structure structure = model::as_built(design);
  const model::State state = model::make_state(structure, design.pose);
  const certify::Closest found = certify::closest(structure, state);
  std::vector<Json> pairs;
  const auto add = [&](const char* kind, double distance, Json places, Json cables) {
    pairs.push_back({{"kind", kind},
                     {"distance", seen(distance)},
                     {"places", std::move(places)},
                     {"cables", std::move(cables)}});
  };
  const auto place = [](int rod, double s) { return Json{{"rod", rod}, {"s", s}}; };
  for (const auto& pair : certify::closest_rods(structure, state))
    add("strands", pair.distance, {place(pair.rod_a, pair.s_a), place(pair.rod_b, pair.s_b)},
        Json::array());
  if (const auto& pair = found.cable_rod)
    add("cable and rod", pair->distance, Json::array({place(pair->rod, pair->s)}),
        Json::array({pair->cable}));
  if (const auto& pair = found.cables)
    add("cables", pair->distance, Json::array(), {pair->cable_a, pair->cable_b});
  if (const auto& pair = found.marks)
    add("marks", pair->distance, {place(pair->rod, pair->s_a), place(pair->rod, pair->s_b)},
        Json::array());
  std::ranges::stable_sort(pairs, {}, [](const Json& pair) {
    return pair["distance"].is_null() ? 0.0 : pair["distance"].get<double>();
  });
  return pairs;
}

// Of a design that stands, and whose weight is known.
Json modes_json(const model::Design& design) {
  constexpr int count = 4;
  Json hertz = Json::array();
  Json shapes = Json::array();
  if (design.certificate && design.certificate->stable && is_known(design.length_unit))
    for (const auto& vibration : pipeline::vibrations(design, count)) {
      Json shape = Json::array();
      for (const auto& rod : vibration.shape) shape.push_back(points(rod));
      hertz.push_back(seen(vibration.hertz));
      shapes.push_back(shape);
    }
  return {{"hertz", hertz}, {"shapes", shapes}};
}

// What is to be added to the design's pose for this one.
Json shape_json(const std::vector<Eigen::Matrix3Xd>& pose, const model::Design& design) {
  Json shape = Json::array();
  for (std::size_t r = 0; r < pose.size(); ++r) shape.push_back(points(pose[r] - design.pose[r]));
  return shape;
}

Json poses_json(const PageDesign& shown) {
  Json result = Json::array();
  for (const PagePose& other : shown.poses)
    result.push_back({{"label", other.label}, {"shape", shape_json(other.pose, shown.design)}});
  return result;
}

// Of a design that stands, unless its many cables would take minutes.
Json shoves_json(const model::Design& design) {
  constexpr std::size_t most_cables = 100;
  Json result = Json::array();
  if (design.structure.cables.size() > most_cables) return result;
  if (!design.certificate || !design.certificate->stable || !is_known(design.length_unit))
    return result;
  for (const pipeline::Shove& shove : pipeline::shoves(design)) {
    Json shapes = Json::array();
    for (const auto& pose : shove.poses) shapes.push_back(shape_json(pose, design));
    result.push_back({{"size", seen(shove.size)},
                      {"smooth", shove.smooth},
                      {"rests", shove.rests},
                      {"away", seen(shove.away)},
                      {"back", shove.back},
                      {"shapes", shapes}});
  }
  return result;
}

// Rods over rods as seen from the front, from the first rod's start on.
Json crossings_json(const model::Design& design, const Eigen::Matrix3d& axes) {
  std::vector<geometry::Polyline> curves;
  for (std::size_t r = 0; r < design.pose.size(); ++r)
    curves.push_back(model::pose_curve(design, r));
  const auto along = model::arc_lengths(design.structure);
  const auto place = [&](const geometry::EdgePoint& at) {
    const Eigen::VectorXd& knots = along[at.rod].knots();
    return Json{{"rod", at.rod},
                {"s", seen((1 - at.t) * knots[at.edge] + at.t * knots[at.edge + 1])}};
  };
  Json crossings = Json::array();
  for (const fabricate::Crossing& one : fabricate::crossings(curves, axes))
    crossings.push_back(
        {{"over", place(one.over)}, {"under", place(one.under)}, {"height", seen(one.height)}});
  return crossings;
}

// From the side that counts most, if any does more than others.
Eigen::Matrix3d axes_of(const model::Design& design) {
  if (!design.views.empty()) return axes_along(design.views);
  std::vector<double> all;
  for (const auto& pose : design.pose)
    all.insert(all.end(), pose.reshaped().begin(), pose.reshaped().end());
  const auto anchors = design.structure.anchors.reshaped();
  all.insert(all.end(), anchors.begin(), anchors.end());
  return principal_axes(
      Eigen::Map<const Eigen::Matrix3Xd>(all.data(), 3, static_cast<Eigen::Index>(all.size()) / 3));
}

Json axes_json(const Eigen::Matrix3d& axes) {
  Json rows = Json::array();
  for (const auto& row : axes.rowwise()) rows.push_back({row[0], row[1], row[2]});
  return rows;
}

// The content of the design's file.
Json file_json(const PageDesign& shown) {
  if (!shown.file_text.empty()) {
    Json json = Json::parse(shown.file_text, nullptr, false);
    if (json.is_object() && json.contains("schema")) return json;  // not of another program
  }
  return Json::parse(io::design_text(shown.design));
}

}  // namespace

std::string page_data(const PageDesign& shown) {
  const model::Design& design = shown.design;
  const auto fields = model::vertex_fields(design);
  Json rods = Json::array();
  for (std::size_t r = 0; r < fields.size(); ++r) rods.push_back(rod_json(design, r, fields[r]));
  const Eigen::Matrix3d axes = axes_of(design);
  const Json drawn{{"axes", axes_json(axes)},         {"rods", rods},
                   {"closest", closest_json(design)}, {"crossings", crossings_json(design, axes)},
                   {"modes", modes_json(design)},     {"poses", poses_json(shown)},
                   {"shoves", shoves_json(design)}};
  return Json{{"file", file_json(shown)}, {"drawn", drawn}}.dump();
}

}  // namespace tencer::app
