// What a stage keeps while it runs: its name, clock and counts, from which its rows are made.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <tencer/sensitivity/target.hpp>
#include <tencer/sparsify/network.hpp>

#include "removal.hpp"

namespace tencer::sparsify {

class StageClock {
 public:
  StageClock(std::string stage, const Control& control);

  double seconds() const;
  bool stopped() const { return control_.stop.stop_requested(); }
  void report(int cables, double max_percent) const;

  void count(const Effort& effort);

  // A row for what was done since the last row, or since the start; also reported as progress.
  StageRow row(const Network& network, const sensitivity::Target& target, std::string note = {});
  // Adds what was done since the last row, to no avail, to `row`.
  void add_rest(StageRow& row);

 private:
  using Time = std::chrono::steady_clock::time_point;
  std::string stage_;
  const Control& control_;
  Time begin_ = std::chrono::steady_clock::now();
  Time last_row_ = begin_;
  Effort effort_;
};

// What keeps a network from being in stable equilibrium with every cable pulling; empty when
// nothing does.
std::string unsoundness(const Network& network);

// Completes a stage's result: interrupted, sound, and in the last row's note why it is not.
// Attempts since the last row are added to it; there is a row when there was none.
void finish(StageResult& result, const sensitivity::Target& target, StageClock& clock);

// The result of a stage that cannot start because its network is not sound; none when it is.
std::optional<StageResult> refused(const Network& network, const sensitivity::Target& target,
                                   StageClock& clock);

}  // namespace tencer::sparsify
