#include "route.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <sstream>
#include <tencer/pipeline/hand_over.hpp>
#include <tencer/pipeline/symmetry.hpp>
#include <tencer/sparsify/decimate.hpp>
#include <tencer/sparsify/dense.hpp>
#include <tencer/sparsify/search.hpp>
#include <tencer/sparsify/slide.hpp>
#include <tencer/sparsify/sparsify.hpp>
#include <tencer/symmetry/subgroups.hpp>
#include <thread>
#include <utility>

namespace tencer::pipeline {
namespace {

constexpr int largest_hint = 24;  // operations of symmetric networks to begin with

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
    if (begun_ && result_.network.structure.cables.empty()) return *this;
    return always(stage);
  }

  // Also without cables.
  template <class Stage>
  Route& always(Stage&& stage) {
    if (result_.interrupted) return *this;
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
                  const CandidateSets& candidates, const optimize::Backend& backend,
                  bool every_number, const DesignOptions& options) {
  const sensitivity::Target& target = prepared.target;
  const sparsify::Control control{.stop = options.stop, .progress = options.progress};
  const sparsify::OuterOptions outer{.second_derivatives = second_derivatives(settings.hessian)};
  const sparsify::Network bare{prepared.structure, prepared.start};
  const symmetry::Group* const symmetry = prepared.symmetry ? &*prepared.symmetry : nullptr;
  std::vector<sparsify::Choice> choices;
  const auto keep = [&](sparsify::ThinResult thinned) {
    choices = std::move(thinned.choices);
    return std::move(thinned.stage);
  };
  const auto thin_options = [&](int cables, bool all_numbers) {
    return sparsify::ThinOptions{.max_percent = settings.max_error,
                                 .cables = cables,
                                 .every_number = all_numbers,
                                 .measure = settings.objective == "rms"
                                                ? sparsify::Measure::rms
                                                : sparsify::Measure::largest,
                                 .threads = threads_of(settings)};
  };
  // Before pins are handed over, all numbers of cables are of use, and there must be room for the
  // cables that come to these.
  const int asked = settings.cables.value_or(0);
  const int further = settings.hand_over ? static_cast<int>(prepared.structure.pins.size()) *
                                               (prepared.structure.planar ? 2 : 3)
                                         : 0;
  const auto first_options = thin_options(asked > 0 ? std::max(1, asked - further) : 0,
                                          every_number || settings.hand_over);
  const auto slide = [&](const sparsify::Network& network) {
    return sparsify::slide(network, target, prepared.rules, backend, outer, control);
  };

  sparsify::Network start = bare;
  if (settings.method == "dense-springs") {
    start.structure.cables =
        sparsify::dense_springs(prepared.structure, target.points, candidates.with_pins);
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
        .then([&](const auto& network) {
          return keep(sparsify::thin(network, target, prepared.rules, candidates.with_pins,
                                     symmetry, first_options, control));
        });
  } else {
    std::vector<symmetry::Group> hints;
    if (!symmetry) hints = symmetry::subgroups(near_symmetry(prepared), largest_hint);
    route.then([&](const auto& network) {
      return keep(sparsify::search(network, target, prepared.rules, candidates.with_pins, symmetry,
                                   hints, first_options, control));
    });
  }
  if (settings.hand_over)
    route
        .always([&](const auto& network) {
          // Few cables may leave so much to the pins that it is more than cables can take over:
          // then from a network with more.
          std::vector<sparsify::Network> pinned{network};
          for (auto& choice : choices)
            if (choice.network.structure.cables.size() > network.structure.cables.size())
              pinned.push_back(std::move(choice.network));
          choices.clear();
          sparsify::StageResult handed;
          for (const auto& one : pinned) {
            handed = hand_over(one, target, symmetry, prepared.rules.longest, control);
            if (handed.sound && handed.trace.back().max_percent <= settings.max_error) break;
          }
          return handed;
        })
        .then([&](const auto& network) {
          return keep(sparsify::thin(network, target, prepared.rules, candidates.without_pins,
                                     symmetry, thin_options(asked, every_number), control));
        });

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
