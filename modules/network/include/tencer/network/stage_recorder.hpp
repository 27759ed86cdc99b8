// What a stage keeps while it runs: its name, clock and counts, from which its rows are made.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <tencer/model/target.hpp>
#include <tencer/network/stage.hpp>

namespace tencer::network {

// Equilibria solved for, and Newton iterations in all of them.
struct SolveCounts {
  int solves = 0;
  int iterations = 0;

  SolveCounts& operator+=(const SolveCounts& other) {
    solves += other.solves;
    iterations += other.iterations;
    return *this;
  }
};

// Refers to the control. report() may be called by several threads at once; the rest belongs to
// one.
class StageRecorder {
 public:
  StageRecorder(std::string stage, const Control& control);

  double seconds() const;
  bool stopped() const { return control_.stop.stop_requested(); }
  void report(int cables, double max_percent) const;

  void add(const SolveCounts& counts);

  // Keeps how a network stands that is gone through, for the next row.
  void pass(const Network& network, const model::Target& target);

  // A row for what was done since the last row, or since the start; also reported as progress.
  model::StageRow row(const Network& network, const model::Target& target, std::string note = {});

  // Completes a stage's result: interrupted, fault, and in the last row's note what is wrong.
  // Attempts since the last row are added to it; there is a row when there was none.
  void finish(StageResult& result, const model::Target& target);

  // The result of a stage that cannot start because its network has a fault; none when it has not.
  [[nodiscard]] std::optional<StageResult> refusal(const Network& network,
                                                   const model::Target& target);

 private:
  using Time = std::chrono::steady_clock::time_point;
  std::string stage_;
  const Control& control_;
  Time begin_ = std::chrono::steady_clock::now();
  Time last_row_ = begin_;
  SolveCounts counts_;
  std::vector<model::Snapshot> snapshots_{};
};

}  // namespace tencer::network
