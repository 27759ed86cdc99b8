#include "route.hpp"

#include <algorithm>
#include <sstream>
#include <tencer/sparsify/balance.hpp>
#include <tencer/sparsify/decimate.hpp>
#include <tencer/sparsify/dense.hpp>
#include <tencer/sparsify/slide.hpp>
#include <tencer/sparsify/sparsify.hpp>
#include <thread>
#include <utility>

namespace tencer::pipeline {
namespace {

sparsify::SecondDerivatives second_derivatives(const std::string& name) {
  if (name == "exact") return sparsify::SecondDerivatives::exact;
  if (name == "gauss-newton") return sparsify::SecondDerivatives::gauss_newton;
  return sparsify::SecondDerivatives::none;
}

int threads_of(const io::DesignSettings& settings) {
  const auto has = static_cast<int>(std::thread::hardware_concurrency());  // 0: not known
  return settings.threads.value_or(std::max(has, 1));
}

io::TraceRow trace_row(const sparsify::StageRow& row) {
  return {.stage = row.stage,
          .seconds = row.seconds,
          .cables = row.cables,
          .max_percent = row.max_percent,
          .rms_percent = row.rms_percent,
          .equilibrium_solves = row.solves,
          .newton_iterations = row.iterations,
          .note = row.note};
}

// The stages one after the other; ends early when one is interrupted, or leaves no cables: the rods
// then rest without.
class Route {
 public:
  Route(const DesignOptions& options, sparsify::Network start) : options_(options) {
    result_.network = std::move(start);
  }

  template <class Stage>
  Route& then(Stage&& stage) {
    if (result_.interrupted || (begun_ && result_.network.structure.cables.empty())) return *this;
    begun_ = true;
    sparsify::StageResult next = stage(result_.network);
    for (const auto& row : next.trace) {
      std::ostringstream line;
      line << row.stage << ": " << row.cables << " cables, max error " << row.max_percent << " %, "
           << row.seconds << " s" << (row.note.empty() ? "" : "; ") << row.note;
      if (options_.log) options_.log(core::Level::info, line.str());
      trace_.push_back(trace_row(row));
    }
    result_ = std::move(next);
    return *this;
  }

  const sparsify::StageResult& result() const { return result_; }
  std::vector<io::TraceRow> take_trace() { return std::move(trace_); }

 private:
  const DesignOptions& options_;
  sparsify::StageResult result_;
  std::vector<io::TraceRow> trace_;
  bool begun_ = false;
};

}  // namespace

Outcome run_route(const io::DesignSettings& settings, const Prepared& prepared,
                  std::span<const springs::Cable> candidates, const optimize::Backend& backend,
                  bool every_number, const DesignOptions& options) {
  const sensitivity::Target& target = prepared.target;
  const sparsify::Control control{.stop = options.stop, .progress = options.progress};
  const sparsify::OuterOptions outer{.second_derivatives = second_derivatives(settings.hessian)};
  const sparsify::Network bare{prepared.structure, prepared.start};
  const symmetry::Group* const symmetry = prepared.symmetry ? &*prepared.symmetry : nullptr;
  std::vector<sparsify::Choice> choices;
  const auto thin = [&](const sparsify::Network& network) {
    auto thinned =
        sparsify::thin(network, target, prepared.rules, candidates, symmetry,
                       {.max_percent = settings.max_error,
                        .cables = settings.cables.value_or(0),
                        .every_number = every_number,
                        .measure = settings.objective == "rms" ? sparsify::Measure::rms
                                                               : sparsify::Measure::largest,
                        .threads = threads_of(settings)},
                       control);
    choices = std::move(thinned.choices);
    return std::move(thinned.stage);
  };
  const auto slide = [&](const sparsify::Network& network) {
    return sparsify::slide(network, target, prepared.rules, backend, outer, control);
  };

  sparsify::Network start = bare;
  if (settings.method == "dense-springs") {
    start.structure.cables = sparsify::dense_springs(prepared.structure, target.points,
                                                     {candidates.begin(), candidates.end()});
    for (auto& cable : start.structure.cables) cable.stiffness *= settings.spring_stiffness / 100;
  }
  Route route(options, std::move(start));
  if (settings.method == "dense-springs") {
    route.then([&](const auto& network) { return sparsify::prune(network, target, control); })
        .then([&](const auto& network) {
          return sparsify::decimate(network, target, {.threshold = settings.greedy_threshold},
                                    control);
        })
        .then([&](const auto& network) {
          return sparsify::sparsify(network, target, backend,
                                    {.max_percent = settings.max_error,
                                     .weights = settings.sparsity_weights,
                                     .longest = prepared.rules.longest,
                                     .outer = outer},
                                    control);
        })
        .then(slide)
        .then(thin);
  } else {
    route
        .then([&](const auto& network) {
          return sparsify::balance(network, target, candidates, symmetry,
                                   {.percent = std::clamp(settings.max_error / 2, 1e-3, 0.1)},
                                   control);
        })
        .then(thin);
  }

  const sparsify::StageResult& result = route.result();
  Outcome outcome{.interrupted = result.interrupted};
  outcome.trace = route.take_trace();
  for (auto& choice : choices) outcome.networks.push_back(std::move(choice.network));
  const auto count = result.network.structure.cables.size();
  const auto at = std::ranges::find_if(outcome.networks, [&](const auto& network) {
    return network.structure.cables.size() >= count;
  });
  outcome.asked = static_cast<int>(at - outcome.networks.begin());
  if (at == outcome.networks.end()) outcome.networks.push_back(result.network);
  return outcome;
}

}  // namespace tencer::pipeline
