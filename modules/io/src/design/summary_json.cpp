#include <cmath>
#include <tencer/io/feasibility.hpp>
#include <tencer/io/summary.hpp>

#include "design/design_json.hpp"
#include "design/pretty_json.hpp"

namespace tencer::io {
namespace {

using Json = nlohmann::ordered_json;

Json in_short(const model::Design& design) {
  Json result = design_to_json(design);
  for (const char* key :
       {"schema", "rods", "anchors", "pinned", "point_loads", "line_loads", "planar", "trace"})
    result.erase(key);
  return result;
}

Json to_json(const NamedValue& named) {
  if (const auto* number = std::get_if<double>(&named.value))
    return std::isfinite(*number) ? Json(*number) : Json(nullptr);
  if (const auto* text = std::get_if<std::string>(&named.value)) return *text;
  return std::get<bool>(named.value);
}

}  // namespace

std::string summary_text(const model::Design& design, const std::vector<NamedValue>& beside,
                         std::span<const model::Design> trade_off) {
  Json result = in_short(design);
  for (const NamedValue& named : beside) result[named.name] = to_json(named);
  for (const model::Design& other : trade_off) result["trade_off"].push_back(in_short(other));
  return pretty(result);
}

std::string summary_text(const model::Feasibility& feasibility) {
  Json result = Json::parse(feasibility_text(feasibility));
  result.erase("rods");
  return pretty(result);
}

}  // namespace tencer::io
