#include <tencer/io/check.hpp>

#include "design/design_json.hpp"
#include "design/json_value.hpp"
#include "design/parse_design.hpp"
#include "design/pretty_json.hpp"
#include "text/bad_input.hpp"
#include "text/read_text.hpp"

namespace tencer::io {
namespace {

using namespace model;
using Json = nlohmann::ordered_json;

Json to_json(const Stands& stands) {
  return {{"rests", stands.rests},
          {"certified", stands.certified},
          {"moved", stands.moved},
          {"residual", stands.residual},
          {"smallest_eigenvalue", stands.smallest_eigenvalue},
          {"slack_cables", stands.slack_cables},
          {"hertz", stands.hertz},
          {"free_groups", stands.free_groups}};
}

Json to_json(const Repair& repair) {
  if (!repair.problem.empty()) return {{"problem", repair.problem}};
  if (repair.cables == 0) return {{"cables", 0}};
  return {{"cables", repair.cables},
          {"first_cable", repair.first_cable},
          {"least_tension", repair.least_tension},
          {"most_tension", repair.most_tension},
          {"moved", repair.moved}};
}

Json cable_or_none(int cable) { return cable < 0 ? Json(nullptr) : Json(cable); }

Json to_json(const Forgives& forgives) {
  Json result{{"length_error", forgives.length_error},
              {"attachment_error", forgives.attachment_error},
              {"max_deviation", forgives.max_deviation},
              {"draws", forgives.draws},
              {"expected", forgives.expected},
              {"percentile_95", forgives.percentile_95},
              {"worst", forgives.worst},
              {"decisive_cable", cable_or_none(forgives.decisive_cable)},
              {"decisive", forgives.decisive},
              {"first_slack", cable_or_none(forgives.first_slack)},
              {"slack_at", forgives.slack_at},
              {"settled", forgives.settled},
              {"fallen", forgives.fallen},
              {"settled_worst", forgives.settled_worst},
              {"falls_up_to", forgives.falls_up_to}};
  if (forgives.falls_at) result["falls_at"] = *forgives.falls_at;
  return result;
}

Json to_json(const ComesBack& comes_back) {
  Json pushes = Json::array();
  for (const Pushes& one : comes_back.pushes)
    pushes.push_back({{"size", one.size},
                      {"tried", one.tried},
                      {"back", one.back},
                      {"lost", one.lost},
                      {"strands_met", one.strands_met}});
  Json others = Json::array();
  for (const OtherPose& other : comes_back.others)
    others.push_back(
        {{"distance", other.distance}, {"energy", other.energy}, {"times", other.times}});
  return {{"pushes", pushes}, {"other_poses", others}};
}

Json to_json(const Holds& holds) {
  Json result;
  if (holds.rod >= 0)
    result = {{"strain", holds.strain},
              {"rod", holds.rod},
              {"s", holds.s},
              {"material", holds.material},
              {"strain_limit", holds.strain_limit}};
  result["tension"] = holds.tension;
  result["cable"] = cable_or_none(holds.cable);
  result["breaking_load"] = holds.breaking_load;
  return result;
}

Json to_json(const Sag& sag) {
  Json at = Json::array();
  for (const auto& [rod, vertex, s] : sag.at)
    at.push_back({{"rod", rod}, {"vertex", vertex}, {"s", s}});
  return {{"deviation", sag.deviation}, {"at", at}, {"settled", sag.settled}, {"falls", sag.falls}};
}

Json to_json(const OwnWeight& weight) {
  Json result{{"included", weight.included}};
  if (weight.hung) result[weight.held ? "held" : "hung"] = to_json(*weight.hung);
  if (weight.standing) result["standing"] = to_json(*weight.standing);
  return result;
}

Json to_json(const Clear& clear) {
  Json result = Json::object();
  const auto add = [&](const char* key, const std::optional<LeastDistance>& least) {
    if (least) result[key] = {{"distance", least->distance}, {"where", least->where}};
  };
  add("rods", clear.rods);
  add("cable_rod", clear.cable_rod);
  add("cables", clear.cables);
  add("marks", clear.marks);
  return result;
}

Json to_json(const Converged& converged) {
  Json refinements = Json::array();
  for (const Refinement& refinement : converged.refinements)
    refinements.push_back({{"times", refinement.times},
                           {"moved", refinement.moved},
                           {"settles", refinement.settles}});
  return {{"converged", converged.converged},
          {"allowed", converged.allowed},
          {"distance", converged.distance},
          {"refinements", refinements}};
}

Json to_json(const Check& check, const Design& design) {
  const CheckTerms terms = terms_of(design);
  const std::vector<std::string> fails = shortfalls(check, terms);
  const std::vector<CheckLine> said = sections(check, terms);
  const std::vector<std::string> missing = not_looked_at(said);
  Json result;
  // Nobody takes a part that fails nothing for a check that is passed.
  result["passed"] = fails.empty() && !missing.empty() ? Json(nullptr) : Json(fails.empty());
  result["fails"] = fails;
  result["not_looked_at"] = missing;
  Json lines = Json::array();
  for (const CheckLine& line : said)
    lines.push_back({{"section", line.section}, {"text", line.text}, {"fails", line.fails}});
  result["lines"] = lines;
  result["length_unit"] = design.length_unit;
  result["force_unit"] = design.force_unit;
  const auto add = [&](const char* key, const auto& section) {
    if (section) result[key] = to_json(*section);
  };
  add("repair", check.repair);
  add("stands", check.stands);
  add("forgives", check.forgives);
  add("comes_back", check.comes_back);
  add("holds", check.holds);
  add("weight", check.weight);
  add("clear", check.clear);
  add("converged", check.converged);
  return result;
}

FiledCheck filed_check(const JsonValue& json) {
  FiledCheck check;
  if (const JsonValue passed = json["passed"]; !passed.raw().is_null())
    check.passed = passed.boolean();
  for (const JsonValue& reason : json["fails"].items()) check.fails.push_back(reason.text());
  for (const JsonValue& line : json["lines"].items())
    check.lines.push_back({line["section"].text(), line["text"].text(), line["fails"].boolean()});
  // What is not finite is no number in the file.
  if (json.has("forgives") && json["forgives"]["percentile_95"].raw().is_number()) {
    const JsonValue forgives = json["forgives"];
    check.tolerance = {forgives["length_error"].at_least_zero(),
                       forgives["attachment_error"].at_least_zero(),
                       forgives["percentile_95"].at_least_zero()};
  }
  return check;
}

}  // namespace

std::string check_text(const Design& design, const Check& check) {
  return pretty(to_json(check, design));
}

Json check_to_json(const Check& check, const Design& design) { return to_json(check, design); }

core::Expected<CheckedDesign> read_checked_design(const std::filesystem::path& path) {
  return guarded([&] {
    const nlohmann::json content = parse_design(path);
    const JsonValue root(content, shown(path));
    CheckedDesign read{.design = any_design(root, path)};
    if (root.has("check")) read.check = filed_check(root["check"]);
    return read;
  });
}

}  // namespace tencer::io
