// The data of the paper's figures, from our own curves: CSV on standard output.
//   bench_figures knots            figures 5 and 14: random closed rods, greedy and global
//   bench_figures ring             figure 8: a ring with a cable across it
//   bench_figures pruning SCENE    inset of section 5.2: springs left after pruning, by stiffness
// docs/figures/make.sh runs them and draws.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <numbers>
#include <string>
#include <string_view>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/ground_structure/dense_springs.hpp>
#include <tencer/io/scene.hpp>
#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/prepare.hpp>
#include <tencer/random_targets/random_knot.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <tencer/sparsify/greedy.hpp>
#include <tencer/sparsify/sparsify.hpp>

using namespace tencer;

namespace {

template <class T>
T value(core::Expected<T> expected) {
  if (expected) return *std::move(expected);
  std::cerr << expected.error().text() << '\n';
  std::exit(2);
}

double percent(const network::Network& network, const model::Target& target) {
  return sensitivity::deviation(target, network.state).max_percent;
}

network::Network dense(const ground_structure::Problem& problem, double factor = 100) {
  network::Network network = problem.bare();
  network.structure.cables = ground_structure::dense_springs(
      problem.structure, problem.target.points, problem.candidates, factor);
  return network;
}

// The greedy removal of section 5.2, to so many springs instead of to an error.
network::Network greedy(const ground_structure::Problem& problem, int springs) {
  const auto pruned = sparsify::prune(dense(problem), problem.target);
  return sparsify::remove_greedily(pruned.network, problem.target,
                                   {.threshold = 1e3, .min_springs = springs})
      .network;
}

void knots() {
  std::printf(
      "made,seed,vertices,found,max_percent,seconds,settles,greedy,greedy_percent,"
      "stiffness_percent,global,global_percent\n");
  const auto backend = value(optimize::find_backend(pipeline::backends(), "gauss-newton"));
  for (const int made : {4, 6, 8, 10, 12})
    for (int seed = 1; seed <= 10; ++seed) {
      const int vertices = 60 + 20 * (seed % 3);
      const auto knot = random_targets::random_knot(
          {.cables = made, .vertices = vertices, .seed = static_cast<std::uint64_t>(seed)});
      if (!knot) continue;
      model::Scene scene = value(io::scene_of_curves({knot->curve}, "random-knot"));
      scene.design.symmetry = model::SymmetryUse::none;
      const auto begin = std::chrono::steady_clock::now();
      const model::Design design = value(pipeline::design(scene));
      const double seconds =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

      // As few springs as made it, by all three.
      const auto problem = value(pipeline::prepare(scene)).problem;
      const auto few = greedy(problem, made);
      const double greedy_percent = percent(few, problem.target);
      const auto fitted =
          sparsify::sparsify(few, problem.target, backend,
                             {.max_error_percent = 1.001 * greedy_percent, .weights = {0}});
      scene.design.cables = made;
      const model::Design global = value(pipeline::design(scene));
      std::printf("%d,%d,%d,%zu,%.4g,%.3g,%d,%zu,%.4g,%.4g,%zu,%.4g\n", made, seed, vertices,
                  design.built.size(), design.error->max_percent, seconds,
                  design.status == model::DesignStatus::complete, few.structure.cables.size(),
                  greedy_percent, percent(fitted.network, problem.target), global.built.size(),
                  global.error->max_percent);
      std::fflush(stdout);
    }
}

// The smallest side of the box about the points along their principal axes.
double smallest_side(const Eigen::Matrix3Xd& points) {
  const Eigen::Matrix3Xd centred = points.colwise() - points.rowwise().mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(centred * centred.transpose());
  const Eigen::Matrix3Xd along = axes.eigenvectors().transpose() * centred;
  return (along.rowwise().maxCoeff() - along.rowwise().minCoeff()).minCoeff();
}

void ring() {
  constexpr int vertices = 160;
  constexpr double target_length = 0.2;  // over the diameter, as all lengths
  const double diameter = 1 / std::numbers::pi;
  model::Structure flat;
  flat.rods = {{.closed = true,
                .section = {.EA = 1e7, .EI1 = 1, .EI2 = 1, .GJ = 0.77},
                .rest_lengths = Eigen::VectorXd::Constant(vertices, 1.0 / vertices)}};
  flat.planar = true;
  flat.cables = {{.a = springs::OnRod{0, 0.0}, .b = springs::OnRod{0, 0.5}, .stiffness = 1}};
  model::Structure free = flat;
  free.planar = false;
  Eigen::Matrix3Xd circle = Eigen::Matrix3Xd::Zero(3, vertices);
  for (int i = 0; i < vertices; ++i)
    circle.col(i).head<2>() << std::cos(2 * std::numbers::pi * i / vertices) * diameter / 2,
        std::sin(2 * std::numbers::pi * i / vertices) * diameter / 2;

  struct Row {
    double length = 0;
    Eigen::Matrix3Xd flat, free;
  };
  std::vector<Row> rows;
  auto in_plane = model::make_state(flat, {circle});
  auto in_space = in_plane;
  for (int step = 1; step <= 96; ++step) {
    const double length = 1 - 0.01 * step;
    flat.cables[0].rest_length = free.cables[0].rest_length = length * diameter;
    in_plane = equilibrium::relax_inextensible(flat, in_plane).equilibrium.state;
    in_space = equilibrium::relax_inextensible(free, in_space).equilibrium.state;
    rows.push_back({length, in_plane[0].x, in_space[0].x});
  }
  const auto at_target = std::ranges::min_element(
      rows, {}, [&](const Row& row) { return std::abs(row.length - target_length); });
  const auto target = model::make_target(flat, {at_target->flat});
  model::Target aligned = target;
  aligned.planar = false;
  std::printf("length,side,flat_percent,free_percent\n");
  for (const Row& row : rows)
    std::printf("%.4g,%.6g,%.6g,%.6g\n", row.length, smallest_side(row.free) / diameter,
                sensitivity::deviation(target, model::make_state(flat, {row.flat})).max_percent,
                sensitivity::deviation(aligned, model::make_state(free, {row.free})).max_percent);
}

void pruning(const char* path) {
  const auto problem = value(pipeline::prepare(value(io::read_scene(path)))).problem;
  std::printf("factor,springs,max_percent\n");
  for (int k = -4; k <= 16; ++k) {
    const double factor = std::pow(10, k / 2.0);
    const auto pruned = sparsify::prune(dense(problem, factor), problem.target);
    std::printf("%.4g,%zu,%.4g\n", factor, pruned.network.structure.cables.size(),
                percent(pruned.network, problem.target));
    std::fflush(stdout);
  }
}

}  // namespace

int main(int count, char** arguments) {
  const std::string_view what = count > 1 ? arguments[1] : "";
  if (what == "knots" && count == 2)
    knots();
  else if (what == "ring" && count == 2)
    ring();
  else if (what == "pruning" && count == 3)
    pruning(arguments[2]);
  else {
    std::cerr << "usage: bench_figures knots | ring | pruning SCENE\n";
    return 2;
  }
  return 0;
}
