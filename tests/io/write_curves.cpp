#include <catch2/catch.hpp>
#include <filesystem>
#include <tencer/curves/analytic.hpp>
#include <tencer/io/curve.hpp>
#include <tencer/io/write_curves.hpp>

#include "fixtures/folder.hpp"

using tencer::geometry::Polyline;
using tencer::io::write_curves;

TEST_CASE("curves come back from every format in which they are written, with their unit") {
  const Folder folder;
  std::vector<Polyline> curves = tencer::curves::twin_trefoils(27, 10.8, 30);
  curves[1].closed = false;
  for (const char* name : {"c.csv", "c.tsv", "c.txt", "c.xyz", "c.json", "c.vect", "c.dxf", "c"}) {
    CAPTURE(name);
    REQUIRE_FALSE(write_curves(folder / name, curves, "mm"));
    const auto again = tencer::io::read_curve_file(folder / name);
    if (!again) FAIL(again.error().text());
    REQUIRE(again->curves.size() == 2);
    for (int i = 0; i < 2; ++i) {
      CHECK(again->curves[i].closed == curves[i].closed);
      CHECK(again->curves[i].points == curves[i].points);
    }
    const bool says_no_unit = std::string(name) == "c.vect" || std::string(name) == "c";
    CHECK(again->length_unit == (says_no_unit ? std::nullopt : std::optional<std::string>("mm")));
  }
  for (const char* name : {"c.svg", "c.stl", "c.pdf"}) {
    const auto error = write_curves(folder / name, curves, "mm");
    REQUIRE(error);
    CHECK(error->message.find(".csv") != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(folder / name));
  }
}
