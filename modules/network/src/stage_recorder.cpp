#include <cmath>
#include <tencer/network/stage_recorder.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <utility>

namespace tencer::network {
namespace {

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// As it stands, moved onto the target.
model::Snapshot snapshot_of(const Network& network, const sensitivity::Deviation& deviation) {
  std::vector<Eigen::Matrix3Xd> points = model::positions_of(network.state);
  for (Eigen::Matrix3Xd& x : points)
    x = deviation.motion.rotation.transpose() * (x.colwise() - deviation.motion.translation);
  Eigen::Matrix3Xd ends = model::cable_ends(network.structure, points);
  for (std::size_t r = 0; r < points.size(); ++r) {
    if (!network.structure.rods[r].closed) continue;
    points[r].conservativeResize(Eigen::NoChange, points[r].cols() + 1);
    points[r].rightCols<1>() = points[r].col(0);
  }
  return {.max_percent = deviation.max_percent,
          .rods = std::move(points),
          .cable_ends = std::move(ends),
          .tensions = cable_tensions(network)};
}

std::string remark_on(const StageResult& result) {
  if (result.fault != Fault::idle_cables) return describe(result.fault);
  return std::to_string(idle_cables(result.network).size()) + " cables do not pull";
}

}  // namespace

StageRecorder::StageRecorder(std::string stage, const Control& control)
    : stage_(std::move(stage)), control_(control) {}

double StageRecorder::seconds() const { return seconds_since(begin_); }

void StageRecorder::report(int cables, double max_percent) const {
  control_.progress({stage_, cables, max_percent, seconds()});
}

void StageRecorder::add(const SolveCounts& counts) { counts_ += counts; }

void StageRecorder::pass(const Network& network, const model::Target& target) {
  const auto deviation = sensitivity::deviation(target, network.state);
  if (std::isfinite(deviation.max_percent)) snapshots_.push_back(snapshot_of(network, deviation));
}

model::StageRow StageRecorder::row(const Network& network, const model::Target& target,
                                   std::string note) {
  const auto deviation = sensitivity::deviation(target, network.state);
  const auto last = std::exchange(last_row_, std::chrono::steady_clock::now());
  const SolveCounts counts = std::exchange(counts_, {});
  if (std::isfinite(deviation.max_percent)) snapshots_.push_back(snapshot_of(network, deviation));
  model::StageRow row{.stage = stage_,
                      .seconds = std::chrono::duration<double>(last_row_ - last).count(),
                      .cables = cable_count(network),
                      .max_percent = deviation.max_percent,
                      .rms_percent = deviation.rms_percent,
                      .solves = counts.solves,
                      .iterations = counts.iterations,
                      .note = std::move(note),
                      .snapshots = std::exchange(snapshots_, {})};
  report(row.cables, row.max_percent);
  return row;
}

void StageRecorder::finish(StageResult& result, const model::Target& target) {
  if (result.trace.empty()) result.trace.push_back(row(result.network, target));
  model::StageRow& last = result.trace.back();
  last.seconds += seconds_since(last_row_);
  last.solves += counts_.solves;
  last.iterations += counts_.iterations;
  last_row_ = std::chrono::steady_clock::now();
  counts_ = {};
  result.interrupted = stopped();
  result.fault = fault_of(result.network);
  for (const std::string& remark :
       {remark_on(result), std::string(result.interrupted ? "interrupted" : "")})
    if (!remark.empty()) last.note += (last.note.empty() ? "" : "; ") + remark;
}

std::optional<StageResult> StageRecorder::refusal(const Network& network,
                                                  const model::Target& target) {
  if (fault_of(network) == Fault::none) return std::nullopt;
  StageResult result{.network = network};
  result.trace.push_back(row(network, target, "not started"));
  finish(result, target);
  return result;
}

}  // namespace tencer::network
