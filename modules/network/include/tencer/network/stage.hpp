// What every stage of a design takes and gives: how it is watched and stopped, the network it ends
// with, and what it did.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/model/stage_row.hpp>
#include <tencer/network/network.hpp>
#include <utility>
#include <vector>

namespace tencer::network {

struct Progress {
  std::string_view stage{};
  int cables = 0;
  double max_percent = 0.0;  // distance to the target, in % of its bounding-box diagonal
  double seconds = 0.0;      // since the stage began
};

// Where progress is told. Stages work on several threads: the function is called by one thread at a
// time, but not always by the same one. Copies share the lock.
class ProgressSink {
 public:
  ProgressSink() = default;  // silent
  template <class Function>
  requires std::is_invocable_v<Function&, const Progress&> ProgressSink(Function function)
      : shared_(std::make_shared<Shared>(std::move(function))) {}

  void operator()(const Progress& progress) const {
    if (!shared_ || !shared_->function) return;
    const std::lock_guard lock(shared_->mutex);
    shared_->function(progress);
  }

 private:
  struct Shared {
    explicit Shared(std::function<void(const Progress&)> given) : function(std::move(given)) {}
    std::mutex mutex{};
    std::function<void(const Progress&)> function;
  };
  std::shared_ptr<Shared> shared_{};
};

// How a stage is watched and stopped, and how accurately equilibria are solved.
struct Control {
  std::stop_token stop{};
  ProgressSink progress{};
  equilibrium::SolveOptions solve{};
};

// What keeps a network from being in stable equilibrium with every cable pulling.
enum class Fault { none, not_checked, idle_cables, not_finite, not_in_equilibrium, not_stable };

// One sentence; empty for none.
[[nodiscard]] std::string describe(Fault fault);

[[nodiscard]] Fault fault_of(const Network& network);

struct [[nodiscard]] StageResult {
  Network network{};
  std::vector<model::StageRow> trace{};
  bool interrupted = false;          // by Control::stop; `network` is the best so far
  Fault fault = Fault::not_checked;  // of `network`

  // The network is in stable equilibrium and every cable pulls.
  bool valid() const { return fault == Fault::none; }
};

}  // namespace tencer::network
