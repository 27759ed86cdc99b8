// The forward solver converges to closed forms with the square of the edge length.
#include "study/closed_forms.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tencer::app::study;

TEST_CASE("every problem's error falls with the square of the edges") {
  constexpr std::array edges{20, 40, 80};
  int told = 0;
  const auto rows = closed_form_errors(edges, [&](const Accuracy&) { ++told; });
  REQUIRE(rows.size() % edges.size() == 0);
  REQUIRE(rows.size() >= 5 * edges.size());
  CHECK(told == static_cast<int>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); i += edges.size()) {
    CAPTURE(rows[i].problem);
    CHECK(rows[i + 2].error < 0.01);
    CHECK(rows[i + 2].error > 0);
    CHECK(std::log2(rows[i + 1].error / rows[i + 2].error) == Approx(2).margin(0.15));
    for (std::size_t k = 0; k < edges.size(); ++k) {
      CHECK(rows[i + k].problem == rows[i].problem);
      CHECK(rows[i + k].edges == edges[k]);
      CHECK(rows[i + k].seconds > 0);
    }
  }
}

TEST_CASE("accuracies as a table") {
  const std::array rows{
      Accuracy{.problem = "ring, energy", .edges = 10, .seconds = 0.5, .error = 0.03}};
  CHECK(accuracy_text(rows) ==
        "problem,edges,seconds,relative_error\n\"ring, energy\",10,0.5,0.03\n");
}
