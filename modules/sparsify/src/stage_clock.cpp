#include "stage_clock.hpp"

#include <tencer/equilibrium/solve.hpp>
#include <utility>

namespace tencer::sparsify {

StageClock::StageClock(std::string stage, const Control& control)
    : stage_(std::move(stage)), control_(control) {}

double StageClock::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

void StageClock::report(int cables, double max_percent) const {
  if (control_.progress) control_.progress({stage_, cables, max_percent, seconds()});
}

void StageClock::count(const Effort& effort) {
  effort_.solves += effort.solves;
  effort_.iterations += effort.iterations;
}

StageRow StageClock::row(const Network& network, const sensitivity::Target& target,
                         std::string note) {
  const auto deviation = sensitivity::deviation(target, network.state);
  const auto now = std::chrono::steady_clock::now();
  const int cables = static_cast<int>(network.structure.cables.size());
  StageRow row{.stage = stage_,
               .seconds = std::chrono::duration<double>(now - last_row_).count(),
               .cables = cables,
               .max_percent = deviation.max_percent,
               .rms_percent = deviation.rms_percent,
               .solves = effort_.solves,
               .iterations = effort_.iterations,
               .note = std::move(note)};
  last_row_ = now;
  effort_ = {};
  report(cables, deviation.max_percent);
  return row;
}

void StageClock::add_rest(StageRow& row) {
  const auto now = std::chrono::steady_clock::now();
  row.seconds += std::chrono::duration<double>(now - last_row_).count();
  row.solves += effort_.solves;
  row.iterations += effort_.iterations;
  last_row_ = now;
  effort_ = {};
}

std::string unsoundness(const Network& network) {
  const auto idle = idle_cables(network).size();
  if (idle > 0) return std::to_string(idle) + " cables do not pull";
  const equilibrium::System system(network.structure);
  if (!(equilibrium::residual(system, network.state) < 1e-6)) return "not in equilibrium";
  equilibrium::Linearisation at;
  equilibrium::linearise(system, network.state, at);
  if (!at.regular || at.negative > 0) return "not stable";
  return {};
}

void finish(StageResult& result, const sensitivity::Target& target, StageClock& clock) {
  if (result.trace.empty()) result.trace.push_back(clock.row(result.network, target));
  clock.add_rest(result.trace.back());
  const std::string fault = unsoundness(result.network);
  result.interrupted = clock.stopped();
  result.sound = fault.empty();
  std::string& note = result.trace.back().note;
  for (const std::string& remark : {fault, std::string(result.interrupted ? "interrupted" : "")})
    if (!remark.empty()) note += (note.empty() ? "" : "; ") + remark;
}

std::optional<StageResult> refused(const Network& network, const sensitivity::Target& target,
                                   StageClock& clock) {
  const std::string fault = unsoundness(network);
  if (fault.empty()) return std::nullopt;
  StageResult result{.network = network};
  result.trace.push_back(clock.row(network, target, "not started"));
  finish(result, target, clock);
  return result;
}

}  // namespace tencer::sparsify
