#include <iostream>
#include <tencer/curves/analytic.hpp>
#include <tencer/elimination/search.hpp>
#include <tencer/ground_structure/candidates.hpp>
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
  const auto result = elimination::search(problem, {.goal = {.max_error_percent = 1}});
  for (const auto& solution : result.solutions)
    std::cout << solution.cables() << " cables, " << solution.max_percent << " %\n";
  return result.stage.valid() ? 0 : 1;
}
