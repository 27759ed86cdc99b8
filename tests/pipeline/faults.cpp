// A method that breaks down in the middle of a design.
#include <stdexcept>

#include "scenes.hpp"

using namespace tencer;

TEST_CASE("what a method throws comes out of the design as it is") {
  model::Scene scene = trefoil_scene();
  scene.design.method = model::Method::dense_springs;
  scene.design.optimizer = model::Optimizer::mma;
  const optimize::Backend broken{.name = "mma",
                                 .description = "breaks",
                                 .minimise = [](const optimize::Problem&, const Eigen::VectorXd&,
                                                const optimize::Options&) -> optimize::Report {
                                   throw std::runtime_error("the method broke");
                                 }};
  CHECK_THROWS_WITH(pipeline::design(scene, {.backends = {broken}}), "the method broke");
}

TEST_CASE("a method that reports nothing but failure leaves a sound design that says so") {
  model::Scene scene = trefoil_scene();
  scene.design.method = model::Method::dense_springs;
  scene.design.optimizer = model::Optimizer::mma;
  const optimize::Backend idle{
      .name = "mma",
      .description = "gives up",
      .minimise = [](const optimize::Problem& problem, const Eigen::VectorXd& start,
                     const optimize::Options&) {
        optimize::Report report;
        report.reason = optimize::Reason::failed;
        report.point = start;
        report.value = problem.value(start).value_or(0);
        return report;
      }};
  const auto design = pipeline::design(scene, {.backends = {idle}});
  REQUIRE(design);
  REQUIRE(design->certificate);
  const auto problem = io::design_problem("design.json", *design);
  CHECK((problem ? problem->text() : "") == "");
}
