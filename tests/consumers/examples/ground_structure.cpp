#include <iostream>
#include <tencer/curves/analytic.hpp>
#include <tencer/ground_structure/candidates.hpp>
#include <tencer/ground_structure/force_balance.hpp>
#include <tencer/model/scaling.hpp>
#include <tencer/model/scene.hpp>

int main() {
  using namespace tencer;
  const model::Scene scene = model::scene_of({curves::ellipse(20, 10, 48)});
  const auto scaling = model::scaling_of(scene.structure, scene.target.points);
  ground_structure::Problem problem{.structure = model::scaled(scene.structure, scaling)};
  problem.target.points = model::scaled(scene.target.points, scaling);
  problem.start = model::make_state(problem.structure, problem.target.points);
  problem.candidates =
      ground_structure::candidates(problem.structure, problem.target.points, {}).value();
  const auto result = ground_structure::force_balance(problem, nullptr);
  std::cout << problem.candidates.size() << " candidates, " << network::cable_count(result.network)
            << " cables hold the ellipse\n";
  return result.valid() ? 0 : 1;
}
