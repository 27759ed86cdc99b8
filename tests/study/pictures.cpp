// What is drawn of a study's runs.
#include "study/pictures.hpp"

#include <catch2/catch.hpp>

using namespace tencer::app::study;

namespace {

Row run(double max_error, int cables, const std::string& status = "complete") {
  return {.run = {.scene = "s",
                  .file = "s.obj",
                  .method = "m",
                  .optimizer = "o",
                  .max_error = max_error},
          .status = status,
          .cables = cables};
}

}  // namespace

TEST_CASE("what an error costs is told of most, half and few of the scenes") {
  std::vector<Row> rows;
  for (int i = 0; i <= 10; ++i) rows.push_back(run(1, 5 + i));
  CHECK(cables_plot(rows).curves.empty());  // one max error alone
  for (int i = 0; i <= 10; ++i) rows.push_back(run(2, 3 + i, i < 6 ? "complete" : "failed"));
  const CountPlot plot = cables_plot(rows);
  REQUIRE(plot.curves.size() == 3);
  CHECK(plot.curves[0].name == "m, o: 9 in 10 need no more");
  // Six of eleven designs are no nine in ten.
  REQUIRE(plot.curves[0].points.size() == 1);
  CHECK(plot.curves[0].points[0].second == 14);
  REQUIRE(plot.curves[1].points.size() == 2);
  CHECK(plot.curves[1].points[0].first == 1);
  CHECK(plot.curves[1].points[0].second == 10);
  CHECK(plot.curves[1].points[1].second == 8);
  CHECK(plot.curves[2].points[1].second == 4);

  const auto files = count_files("study-cables", plot);
  CHECK(files[0].name == "study-cables.dat");
  CHECK_THAT(files[0].text, Catch::Matchers::Contains("# m, o: half\n1 10\n2 8\n"));
  CHECK_THAT(files[1].text, Catch::Matchers::Contains("data index 2 using 1:2"));
}
