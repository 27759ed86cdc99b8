// Forward equilibria of the published models: from the target, with the stored springs, to the
// stored equilibrium. Where another equilibrium is found, the stored one is solved for as well and
// both are listed. Usage: bench_forward FOLDER
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/stability.hpp>
#include <tencer/registration/rigid.hpp>

#include "published_model.hpp"

using namespace tencer;

namespace {

constexpr int repeats = 15;

Eigen::Matrix3Xd stacked(const std::vector<Eigen::Matrix3Xd>& rods) {
  Eigen::Index columns = 0;
  for (const auto& x : rods) columns += x.cols();
  Eigen::Matrix3Xd all(3, columns);
  Eigen::Index at = 0;
  for (const auto& x : rods) {
    all.middleCols(at, x.cols()) = x;
    at += x.cols();
  }
  return all;
}

// Largest distance to the stored equilibrium, in % of the target's bounding-box diagonal.
double distance_percent(const bench::PublishedModel& model, const model::State& state) {
  std::vector<Eigen::Matrix3Xd> x;
  for (const auto& rod : state) x.push_back(rod.x);
  Eigen::Matrix3Xd here = stacked(x);
  const Eigen::Matrix3Xd there = stacked(model.design.pose);
  const Eigen::Matrix3Xd target = stacked(model.design.target);
  if (model.design.structure.anchors.cols() == 0)
    here = registration::align(here, there, Eigen::VectorXd::Ones(here.cols())).apply(here);
  const double diagonal = (target.rowwise().maxCoeff() - target.rowwise().minCoeff()).norm();
  return (here - there).colwise().norm().maxCoeff() / diagonal * 100;
}

// Solves repeatedly, building everything anew each time, and prints one row with the median time.
double report(const bench::PublishedModel& model, const std::vector<Eigen::Matrix3Xd>& start,
              const char* from) {
  using clock = std::chrono::steady_clock;
  equilibrium::Equilibrium result;
  std::vector<double> milliseconds;
  for (int k = 0; k < repeats; ++k) {
    const auto begin = clock::now();
    const equilibrium::System system(model.design.structure);
    result = equilibrium::solve(system, make_state(model.design.structure, start));
    milliseconds.push_back(std::chrono::duration<double, std::milli>(clock::now() - begin).count());
  }
  std::ranges::sort(milliseconds);
  const equilibrium::System system(model.design.structure);
  const auto stability = equilibrium::stability(system, result.state);
  const double distance = distance_percent(model, result.state);
  std::printf("%-21s %-9s %5d %5d %5d %7.2f %7.2f %9.1e %10.2e %9.3g %12.7g  %s\n",
              model.design.name.c_str(), from, system.size(), result.iterations,
              result.factorisations, milliseconds.front(), milliseconds[repeats / 2],
              result.residual, distance, stability.smallest_eigenvalue, result.energy,
              describe(result.reason).c_str());
  return distance;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: bench_forward FOLDER\n");
    return 2;
  }
  std::printf("%-21s %-9s %5s %5s %5s %7s %7s %9s %10s %9s %12s  %s\n", "model", "from", "unkn",
              "iter", "fact", "ms min", "ms med", "residual", "distance %", "lambda", "energy",
              "why");
  for (const auto& model : bench::read_published_models(argv[1]))
    if (report(model, model.design.target, "target") > 1e-3)
      report(model, model.design.pose, "published");
}
