#include <cmath>
#include <string>
#include <tencer/model/target.hpp>

#include "design/design_json.hpp"

namespace tencer::io {
namespace {

using Json = nlohmann::ordered_json;
using model::Snapshot;

// Enough decimals to look at something of this size.
class Decimals {
 public:
  explicit Decimals(double size)
      : per_unit_(size > 0 ? std::pow(10, std::ceil(4 - std::log10(size))) : 1) {}
  // Without the sign of a zero.
  double operator()(double value) const { return std::round(value * per_unit_) / per_unit_ + 0.0; }

 private:
  double per_unit_;
};

Json rounded(const Eigen::Ref<const Eigen::VectorXd>& numbers, const Decimals& decimals) {
  Json result = Json::array();
  for (const double number : numbers) result.push_back(decimals(number));
  return result;
}

Json snapshot_to_json(const Snapshot& snapshot) {
  const Decimals length(model::diagonal({.points = snapshot.rods}));
  const Decimals force(snapshot.cables() ? snapshot.tensions.cwiseAbs().maxCoeff() : 0);
  Json result;
  result["max_percent"] = snapshot.max_percent;
  result["rods"] = Json::array();
  for (const Eigen::Matrix3Xd& points : snapshot.rods)
    result["rods"].push_back(rounded(points.reshaped(), length));
  result["cables"] = Json::array();
  for (int c = 0; c < snapshot.cables(); ++c) {
    Json cable = rounded(snapshot.cable_ends.middleCols<2>(2 * c).reshaped(), length);
    cable.push_back(force(snapshot.tensions[c]));
    result["cables"].push_back(cable);
  }
  return result;
}

Snapshot read_snapshot(const JsonValue& value) {
  Snapshot snapshot{.max_percent = value["max_percent"].at_least_zero()};
  for (const JsonValue& rod : value["rods"].items()) {
    const Eigen::VectorXd numbers = rod.numbers();
    if (numbers.size() < 6 || numbers.size() % 3 != 0)
      rod.fail("expected three numbers for each of two points or more, found " +
               std::to_string(numbers.size()));
    snapshot.rods.push_back(numbers.reshaped(3, numbers.size() / 3));
  }
  const std::vector<JsonValue> cables = value["cables"].items();
  const auto count = static_cast<Eigen::Index>(cables.size());
  snapshot.cable_ends.resize(3, 2 * count);
  snapshot.tensions.resize(count);
  for (Eigen::Index c = 0; c < count; ++c) {
    const Eigen::VectorXd numbers = cables[c].numbers();
    if (numbers.size() != 7)
      cables[c].fail("expected 7 numbers, both ends and the tension, found " +
                     std::to_string(numbers.size()));
    snapshot.cable_ends.middleCols<2>(2 * c) = numbers.head<6>().reshaped(3, 2);
    snapshot.tensions[c] = numbers[6];
  }
  return snapshot;
}

}  // namespace

Json snapshots_to_json(const std::vector<Snapshot>& snapshots) {
  Json result = Json::array();
  for (const Snapshot& snapshot : snapshots) result.push_back(snapshot_to_json(snapshot));
  return result;
}

std::vector<Snapshot> read_snapshots(const JsonValue& list) {
  std::vector<Snapshot> snapshots;
  for (const JsonValue& one : list.items()) snapshots.push_back(read_snapshot(one));
  return snapshots;
}

}  // namespace tencer::io
