#include <tencer/elimination/eliminate.hpp>

#include "multistart/multistart.hpp"

namespace tencer::elimination {

EliminationResult eliminate(const network::Network& network,
                            const ground_structure::Problem& problem,
                            const EliminationOptions& options, const network::Control& control) {
  options.validate();
  validate(problem.rules, network.structure);
  network::StageRecorder recorder("eliminate", control);
  if (auto refusal = recorder.refusal(network, problem.target))
    return {.stage = std::move(*refusal)};
  const Requirements requirements =
      requirements_for(network, problem.target, problem.rules, problem.group(), options);
  Multistart multistart(requirements, problem.candidates, options, control, recorder);
  network::StageResult result{.network = network};
  const Start start{.network = network};
  ParetoArchive archive = multistart.eliminate_from({&start, 1});
  const auto record_it = [&] { record(archive, multistart, problem.target, recorder, result); };
  record_it();
  multistart.iterated_local_search({&archive, 1}, options.local_search.patience, record_it);
  recorder.finish(result, problem.target);
  return {.stage = std::move(result), .solutions = archive.best()};
}

}  // namespace tencer::elimination
