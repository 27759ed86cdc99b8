#include <catch2/catch.hpp>
#include <tencer/model/schedule.hpp>

using namespace tencer::model;

TEST_CASE("changes of a length are read") {
  const auto by = read_length_change("by -12 mm");
  REQUIRE(by);
  CHECK(by->apply(5, 4, "cm") == Approx(3.8));
  CHECK(read_length_change("by +10%")->apply(5, 4, "cm") == Approx(5.4));
  CHECK(read_length_change("to 80 %")->apply(5, 4, "cm") == Approx(3.2));
  CHECK(read_length_change(" to  2cm")->apply(5, 4, "mm") == Approx(20));
  for (const char* text : {"", "by", "by ", "to x mm", "-12 mm", "by 3 feet", "to 3", "by nan mm",
                           "by 1e999 mm", "to inf mm", "by 3 mm more"})
    CHECK_FALSE(read_length_change(text));
}

TEST_CASE("lengths follow step after step") {
  Design design;
  design.length_unit = "cm";
  design.built = {{.length = 10}, {.length = 20}};
  const Schedule schedule{
      {{.changes = {read_length_change("by -10 mm"), std::nullopt}},
       {.changes = {read_length_change("by -10 %"), read_length_change("to 50 %")}},
       {.changes = {read_length_change("to 100 %"), std::nullopt}}}};
  const auto lengths = lengths_of(schedule, design);
  REQUIRE(lengths.size() == 3);
  CHECK(lengths[0].isApprox(Eigen::Vector2d(9, 20)));
  CHECK(lengths[1].isApprox(Eigen::Vector2d(8, 10)));
  CHECK(lengths[2].isApprox(Eigen::Vector2d(10, 10)));
  CHECK_THROWS_AS(lengths_of({{{.changes = {}}}}, design), std::invalid_argument);
}
