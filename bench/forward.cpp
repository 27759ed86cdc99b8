// Forward equilibria of the published models: from the target, with the stored springs, to the
// published equilibrium. Usage: bench_forward FOLDER
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <tencer/equilibrium/built.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/stability.hpp>
#include <tencer/registration/rigid.hpp>

#include "published_model.hpp"

using namespace tencer;

namespace {

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

double seconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: bench_forward FOLDER\n");
    return 2;
  }
  std::printf("%-22s %6s %5s %5s %5s %8s %9s %10s %10s %10s  %s\n", "model", "unkn.", "iter",
              "fact", "eval", "ms", "residual", "to publ. %", "lambda", "built", "why");
  for (const auto& model : bench::read_published_models(argv[1])) {
    equilibrium::Equilibrium result;
    int size = 0;
    std::vector<double> times;
    for (int k = 0; k < 7; ++k)
      times.push_back(seconds_of([&] {
        const equilibrium::System system(model.structure);
        size = system.size();
        result = equilibrium::solve(system, make_state(model.structure, model.target));
      }));
    std::ranges::sort(times);
    std::vector<Eigen::Matrix3Xd> x;
    for (const auto& rod : result.state) x.push_back(rod.x);
    const Eigen::Matrix3Xd here = stacked(x);
    const Eigen::Matrix3Xd there = stacked(model.published);
    const Eigen::Matrix3Xd target = stacked(model.target);
    const double diagonal = (target.rowwise().maxCoeff() - target.rowwise().minCoeff()).norm();
    Eigen::Matrix3Xd moved = here;
    if (model.rigidly_aligned)
      moved = registration::align(here, there, Eigen::VectorXd::Ones(here.cols())).apply(here);
    const double distance = (moved - there).colwise().norm().maxCoeff() / diagonal * 100;
    const equilibrium::System system(model.structure);
    const auto stability = equilibrium::stability(system, result.state);
    const auto certificate = equilibrium::certify(model.structure, result.state,
                                                  system.internal_forces(result.state).tension);
    std::printf("%-22s %6d %5d %5d %5d %8.2f %9.1e %10.2e %10.3g %10.3g  %s\n", model.name.c_str(),
                size, result.iterations, result.factorisations, result.evaluations, times[3] * 1e3,
                result.residual, distance, stability.smallest_eigenvalue,
                certificate.stability.smallest_eigenvalue, describe(result.reason).c_str());
  }
}
