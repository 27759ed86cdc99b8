// Designs for the published models beside the published figures: by force balance with the
// published max error, with the published number of cables and with two thirds of both. As second
// argument, `optimizers` lets each optimizer of the build make the last fit, and `dense-springs`
// takes the paper's route with each.
//
// Usage: bench_design FOLDER [optimizers|dense-springs] [MODEL...]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <set>
#include <string>
#include <string_view>
#include <tencer/model/redesign.hpp>
#include <tencer/pipeline/design.hpp>

#include "published_model.hpp"

using namespace tencer;

namespace {

// Rods of a model whose published cables never join a rod with itself are under that rule.
std::optional<std::vector<model::RodPair>> rod_pairs(const bench::PublishedModel& model) {
  std::vector<model::RodPair> pairs;
  const int rods = static_cast<int>(model.design.structure.rods.size());
  for (int a = 0; a < rods; ++a)
    for (int b = a + 1; b < rods; ++b) pairs.push_back({a, b});
  for (const auto& cable : model.design.structure.cables) {
    const auto* a = std::get_if<springs::OnRod>(&cable.a);
    const auto* b = std::get_if<springs::OnRod>(&cable.b);
    if (a && b && a->rod == b->rod) return std::nullopt;
  }
  return pairs;
}

model::Scene scene_of(const bench::PublishedModel& model) {
  model::Scene scene = model::scene_of(model.design);
  scene.rules.pairs = rod_pairs(model);
  scene.design.max_error = model.max_error_percent;
  return scene;
}

// Seconds by stage, rows of the same stage added up.
std::string stage_seconds(const model::Design& design) {
  std::vector<std::pair<std::string, double>> stages;
  for (const auto& row : design.trace) {
    if (stages.empty() || stages.back().first != row.stage) stages.emplace_back(row.stage, 0);
    stages.back().second += row.seconds;
  }
  std::string text;
  for (const auto& [stage, seconds] : stages) {
    char entry[64];
    std::snprintf(entry, sizeof entry, "%s %.2f  ", stage.c_str(), seconds);
    text += entry;
  }
  return text;
}

// Designs one scene and prints a line of the table.
void print_design(const bench::PublishedModel& model, const model::Scene& scene,
                  const char* question) {
  const auto begin = std::chrono::steady_clock::now();
  const auto design = pipeline::design(scene);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!design) {
    std::printf("%-21s %-20s %s\n", model.design.name.c_str(), question,
                design.error().text().c_str());
    return;
  }
  std::printf("%-21s %-20s %6zu %6d %8.3f %8.3f %7s %9.3g %7s %9.2f  %s\n",
              model.design.name.c_str(), question, design->built.size(), model.cables(),
              design->error->max_percent, model.max_error_percent,
              design->certificate->stable ? "yes" : "no", design->certificate->smallest_eigenvalue,
              design->certificate->settles_from_target.value_or(false) ? "yes" : "no", seconds,
              stage_seconds(*design).c_str());
  std::fflush(stdout);
}

// The same question, answered with each optimizer of the build.
void print_optimizers(const bench::PublishedModel& model, model::Scene scene,
                      const char* question) {
  for (const auto& backend : pipeline::backends()) {
    scene.design.optimizer = *model::named<model::Optimizer>(backend.name);
    print_design(model, scene, (std::string(question) + backend.name).c_str());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: bench_design FOLDER [optimizers|dense-springs] [MODEL...]\n");
    return 2;
  }
  const std::string_view second = argc > 2 ? argv[2] : "";
  const bool optimizers = second == "optimizers";
  const bool dense = second == "dense-springs";
  const std::set<std::string> wanted(argv + (optimizers || dense ? 3 : 2), argv + argc);
  std::printf("%-21s %-20s %6s %6s %8s %8s %7s %9s %7s %9s  %s\n", "model", "asked for", "cables",
              "publ.", "max %", "publ.", "stands", "lambda", "settles", "seconds", "by stage");
  for (const auto& model : bench::read_published_models(argv[1])) {
    if (!wanted.empty() && !wanted.contains(model.design.name)) continue;
    model::Scene scene = scene_of(model);
    if (dense) {
      scene.design.method = model::Method::dense_springs;
      print_optimizers(model, scene, "");
    } else if (optimizers) {
      print_optimizers(model, scene, "max error ");
      scene.design.cables = model.cables();
      print_optimizers(model, scene, "cables ");
    } else {
      print_design(model, scene, "max error");
      scene.design.cables = model.cables();
      print_design(model, scene, "cables");
      scene.design.cables = 2 * model.cables() / 3;
      scene.design.max_error = model.max_error_percent * 2 / 3;
      print_design(model, scene, "two thirds");
    }
  }
}
