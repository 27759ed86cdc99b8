// What gnuplot is given.
#include "study/plot.hpp"

#include <catch2/catch.hpp>
#include <fstream>

using namespace tencer::app::study;
using Catch::Matchers::Contains;

TEST_CASE("a plot has a block of data and a line in each panel for each curve") {
  const Plot plot{.title = "the rod's own",
                  .error_axis = "error",
                  .count_axis = "cables",
                  .allowed = 0.75,
                  .curves = {{.name = "one", .points = {{1, 0.5, 9}, {2, 0.25, 7}}},
                             {.name = "empty"},
                             {.name = "two", .colour = 2, .points = {{3, 1e-3, 0}}}}};
  const auto files = plot_files("knot", plot);
  REQUIRE(files.size() == 2);
  CHECK(files[0].name == "knot.dat");
  CHECK_THAT(files[0].text, Contains("# one\n1 0.5 9\n2 0.25 7\n\n\n# two\n3 0.001 nan\n"));
  CHECK(files[1].name == "knot.gp");
  CHECK_THAT(files[1].text, Contains("set output 'knot.svg'"));
  CHECK_THAT(files[1].text, Contains("title 'the rod''s own'"));
  CHECK_THAT(files[1].text, Contains("set ylabel 'cables'"));
  CHECK_THAT(files[1].text, Contains("0.75 with lines lt 7"));
  for (const std::string panel : {"1:2", "1:3"}) {
    CHECK_THAT(files[1].text, Contains("data index 0 using " + panel));
    CHECK_THAT(files[1].text, Contains("data index 1 using " + panel + " with linespoints lt 2 "));
  }
  CHECK_THAT(files[1].text, !Contains("index 2"));
  CHECK(has_points(plot));
}

TEST_CASE("points that logarithmic axes cannot show are left out") {
  const Plot plot{.curves = {{.points = {{0, 1, 3}, {1, 0, 0}}}}};
  CHECK_FALSE(has_points(plot));
  CHECK_THAT(plot_files("none", plot)[0].text, !Contains("\n1 "));
}

TEST_CASE("an axis within a decade or two has numbers of its own") {
  const Plot plot{.curves = {{.points = {{3, 0.4, 0}, {9, 500, 0}}}}};
  const std::string script = plot_files("near", plot)[1].text;
  CHECK_THAT(script, Contains("set xtics (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50)"));
  CHECK_THAT(script, Contains("set ytics autofreq"));
  const Plot nearer{.curves = {{.points = {{0.61, 0.7, 0}, {0.76, 0.71, 0}}}}};
  const std::string fine = plot_files("nearer", nearer)[1].text;
  CHECK_THAT(fine, Contains(", 0.6, 0.62, 0.64,"));
  CHECK_THAT(fine, Contains("set ytics (0.48, 0.5,"));
}

TEST_CASE("a plot has the style of all figures") {
  const std::string script = plot_files("one", {})[1].text;
  std::ifstream style(TENCER_FIGURE_STYLE);
  int lines = 0;
  for (std::string line; std::getline(style, line);) {
    // Its data are separated by blanks, and it is larger.
    if (!line.starts_with("set ") || line.starts_with("set datafile")) continue;
    if (line.starts_with("set terminal")) line = line.substr(line.find(" font "));
    ++lines;
    CHECK_THAT(script, Contains(line + "\n"));
  }
  CHECK(lines > 10);
}

TEST_CASE("numbers of things are whole") {
  const Plot plot{.curves = {{.points = {{1, 0.4, 6}, {2, 0.5, 7}}}}};
  CHECK_THAT(plot_files("few", plot)[1].text, Contains("set ytics (4, 5, 6, 7, 8, 9)"));
}
