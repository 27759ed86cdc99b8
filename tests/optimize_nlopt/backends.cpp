#include <catch2/catch.hpp>
#include <tencer/optimize_nlopt/backends.hpp>

#include "backend_checks/backend_checks.hpp"

using namespace tencer;

TEST_CASE("mma and ccsaq do what every backend must") {
  const auto backends = optimize_nlopt::backends();
  REQUIRE(backends.size() == 2);
  CHECK(backends[0].name == "mma");
  CHECK(backends[1].name == "ccsaq");
  for (const auto& backend : backends) optimize::test::check_backend(backend);
}

TEST_CASE("active bounds are reached exactly") {
  const auto known = optimize::test::quadratic_with_active_bounds();
  for (const auto& backend : optimize_nlopt::backends()) {
    const auto report = backend.minimise(known.problem, known.start, {.gradient_tolerance = 1e-7});
    for (int i = 0; i < 7; ++i) CHECK(report.point[i] == known.answer[i]);
  }
}
