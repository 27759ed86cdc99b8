// How often a design whose cables are not quite as long as they should be comes to rest elsewhere,
// found by relaxation that starts without tensions and by following the path of equilibria from the
// pose. A jump on the path is the structure's own; what relaxation makes more of is the solver's.
// Usage: bench_settling [draws=N] DESIGN.JSON...
//
// In every draw each cable's length is off by a uniform deviation in +-e. "falls" are draws that
// end more than 1 % of the target's size from the pose, or nowhere; "folds" those whose path turns.
// Factorisations and milliseconds are means of one draw, the path's own of a start prepared once.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>
#include <tencer/equilibrium/path.hpp>
#include <tencer/io/design.hpp>
#include <tencer/model/scaling.hpp>
#include <tencer/model/target.hpp>
#include <tencer/model/units.hpp>
#include <tencer/pipeline/design_state.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <utility>
#include <vector>

using namespace tencer;

namespace {

struct Model {
  model::Structure structure;
  model::State pose;
  Eigen::VectorXd tensions;
  Eigen::VectorXd lengths;  // of the cables as they are built
  model::Target target;     // the pose, as what distances are from
  double size;              // the diagonal of the design's target
  double millimetre;        // scaled
};

Model model_of(const model::Design& design) {
  const model::Scaling scaling = model::scaling_of(design.structure, design.target);
  model::Structure structure = model::scaled(model::as_built(design), scaling);
  model::State pose = pipeline::pose_state(design, structure, scaling);
  const auto cables = static_cast<Eigen::Index>(design.built.size());
  Eigen::VectorXd tensions(cables), lengths(cables);
  for (Eigen::Index c = 0; c < cables; ++c) {
    const auto& built = design.built[static_cast<std::size_t>(c)];
    tensions[c] = built.tension / scaling.scale.force();
    lengths[c] = built.length / scaling.scale.length;
  }
  model::Target target = model::make_target(structure, model::scaled(design.pose, scaling));
  const double size =
      model::diagonal(model::make_target(structure, model::scaled(design.target, scaling)));
  return {.structure = std::move(structure),
          .pose = std::move(pose),
          .tensions = std::move(tensions),
          .lengths = std::move(lengths),
          .target = std::move(target),
          .size = size,
          .millimetre = 1e-3 / model::metres(design.length_unit) / scaling.scale.length};
}

struct Tally {
  int falls = 0;
  int factorisations = 0;
  double seconds = 0;

  // settles() gives an equilibrium::Equilibrium.
  template <class Settles>
  void count(const Model& model, Settles&& settles) {
    const auto begin = std::chrono::steady_clock::now();
    const equilibrium::Equilibrium found = settles();
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    factorisations += found.factorisations;
    const double moved = sensitivity::deviation(model.target, found.state).max / model.size;
    if (!found.usable() || moved > 0.01) ++falls;
  }
};

void measure(const std::string& name, const Model& model, double deviation, int draws) {
  const equilibrium::PathStart start(model.structure, model.pose, model.tensions);
  std::mt19937_64 random(1);
  Tally relaxed, followed;
  int folds = 0;
  for (int draw = 0; draw < draws; ++draw) {
    model::Structure built = model.structure;
    Eigen::VectorXd lengths = model.lengths;
    for (Eigen::Index c = 0; c < lengths.size(); ++c) {
      const double uniform = static_cast<double>(random() >> 11) * 0x1p-52 - 1;  // in [-1, 1)
      lengths[c] += deviation * model.millimetre * uniform;
      built.cables[static_cast<std::size_t>(c)].rest_length = lengths[c];
    }
    if (lengths.minCoeff() <= 0) continue;
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(lengths.size());
    relaxed.count(model, [&] {
      return equilibrium::relax_inextensible(built, model.pose, none).equilibrium;
    });
    followed.count(model, [&] {
      auto path = equilibrium::settle_along(start, lengths);
      if (path.fold_at) ++folds;
      return std::move(path.rest.equilibrium);
    });
  }
  std::printf("| %s | %d | %g | %d | %d | %d | %d | %.1f | %.1f | %.1f | %.1f |\n", name.c_str(),
              static_cast<int>(model.lengths.size()), deviation, draws, relaxed.falls,
              followed.falls, folds, 1.0 * relaxed.factorisations / draws,
              1.0 * followed.factorisations / draws, 1e3 * relaxed.seconds / draws,
              1e3 * followed.seconds / draws);
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
  constexpr std::string_view draws_option = "draws=";
  int draws = 15;
  std::vector<std::string> files;
  for (int i = 1; i < count; ++i) {
    const std::string_view argument = arguments[i];
    if (argument.starts_with(draws_option))
      draws = std::max(1, std::atoi(argument.substr(draws_option.size()).data()));
    else
      files.emplace_back(argument);
  }
  std::puts(
      "| design | cables | +- mm | draws | falls relaxed | falls on path | folds | factorisations "
      "relaxed | on path | ms relaxed | on path |\n|---|---|---|---|---|---|---|---|---|---|---|");
  for (const auto& file : files) {
    const auto design = io::read_design(file);
    if (!design) return std::fprintf(stderr, "%s\n", design.error().text().c_str()), 2;
    if (design->built.empty()) continue;
    const Model model = model_of(*design);
    for (const double deviation : {0.0, 0.01, 0.1, 0.5, 1.0, 2.0})
      measure(file, model, deviation, deviation == 0 ? 1 : draws);
  }
  return 0;
}
