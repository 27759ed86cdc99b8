#include <tencer/io/feasibility.hpp>

#include "design/design_json.hpp"
#include "design/pretty_json.hpp"

namespace tencer::io {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(model::Verdict verdict) {
  switch (verdict) {
    case model::Verdict::can:
      return "can";
    case model::Verdict::unclear:
      return "unclear";
    case model::Verdict::cannot:
      break;
  }
  return "cannot";
}

}  // namespace

std::string feasibility_text(const model::Feasibility& feasibility) {
  Json rods = Json::array();
  for (std::size_t r = 0; r < feasibility.targets.size(); ++r)
    rods.push_back({{"closed", feasibility.targets[r].closed},
                    {"target", points_to_json(feasibility.targets[r].points)},
                    {"motion", points_to_json(feasibility.motions[r])}});
  Json mends = Json::array();
  for (const model::Mend& mend : feasibility.mends)
    mends.push_back({{"change", mend.change}, {"helps", mend.helps}, {"percent", mend.percent}});
  return pretty(Json{{"name", feasibility.name},
                     {"verdict", name_of(feasibility.verdict)},
                     {"max_error", feasibility.max_error},
                     {"percent", feasibility.percent},
                     {"rests", feasibility.rests},
                     {"released", feasibility.released},
                     {"lengthening", feasibility.lengthening},
                     {"unbalanced", feasibility.unbalanced},
                     {"power", feasibility.power},
                     {"at_least", at_least_to_json(feasibility.at_least)},
                     {"apart", feasibility.apart},
                     {"vertices", feasibility.vertices},
                     {"cables", feasibility.cables},
                     {"warnings", feasibility.warnings},
                     {"mends", mends},
                     {"length_unit", feasibility.length_unit},
                     {"rods", rods}});
}

}  // namespace tencer::io
