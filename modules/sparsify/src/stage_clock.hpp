// What a stage keeps while it runs: its name, clock and counts, from which its rows are made.
#pragma once

#include <chrono>
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

 private:
  using Time = std::chrono::steady_clock::time_point;
  std::string stage_;
  const Control& control_;
  Time begin_ = std::chrono::steady_clock::now();
  Time last_row_ = begin_;
  Effort effort_;
};

// In stable equilibrium with every cable pulling.
bool is_sound(const Network& network);

}  // namespace tencer::sparsify
