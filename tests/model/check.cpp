// A check in words: mm, newtons and per cent whatever the design's units.
#include <catch2/catch.hpp>
#include <tencer/model/check.hpp>

using namespace tencer::model;
using Catch::Matchers::Contains;

namespace {

// All well, in cm and kN.
Check fine() {
  Check check;
  check.stands = {
      .rests = true, .moved = 0.01, .allowed = 1, .certified = true, .hertz = {3.125, 4.5}};
  check.forgives = {.length_error = 0.1,
                    .attachment_error = 0.2,
                    .max_deviation = 1,
                    .draws = 100,
                    .percentile_95 = 0.25,
                    .worst = 0.5,
                    .decisive_cable = 3,
                    .first_slack = 2,
                    .slack_at = 4,
                    .settled = 30,
                    .falls_up_to = 8};
  check.comes_back = {.pushes = {{.size = 1, .tried = 20, .back = 20, .strands_met = 1}}};
  check.holds = {.strain = 0.005,
                 .rod = 1,
                 .s = 2,
                 .material = "glass fibre",
                 .strain_limit = 0.01,
                 .tension = 0.05,
                 .cable = 4,
                 .breaking_load = 0.5};
  check.weight = {
      .hung = Sag{.deviation = 0.3, .at = {{0, 7, 8}}},
      .standing = Sag{.deviation = 2, .at = {{0, 1, 0.1}, {0, 4, 4}, {1, 5, 6}}, .settled = true}};
  check.clear = {.rods = LeastDistance{2, "A at 10 and 90 mm"},
                 .cable_rod = LeastDistance{0.3, "cable 1 and A at 40 mm"},
                 .cables = LeastDistance{0.05, "cable 1 and cable 2"}};
  check.converged = {.refinements = {{.times = 2, .moved = 0.01}}, .converged = true};
  return check;
}

const CheckTerms terms{"cm", "kN", 2};

}  // namespace

TEST_CASE("what is fine is told in mm, N and per cent, and nothing fails") {
  const std::string text = report(fine(), terms);
  for (const char* part :
       {"stands: yes", "lowest modes 3.12, 4.5 Hz",
        "cables cut to 1 mm and tied to 2 mm: within 2.5 mm (95 %)", "worst 5 mm of 100 draws",
        "cable 4 matters most", "cables cut to 4 mm and tied to 8 mm)",
        "none falls up to cables cut to 8 mm and tied to 16 mm",
        "20 of 20 pushes by 10 mm (1 of them where strands may have passed",
        "largest strain 0.5 % (B at 20 mm; glass fibre bears 1 % for long)",
        "largest tension 50 N (cable 5), 10 % of the breaking load 500 N",
        "rod to rod 20 mm (A at 10 and 90 mm), cable to rod 3 mm (cable 1 and A at "
        "40 mm), cable to cable 0.5 mm (cable 1 and cable 2), between marks none near",
        "hung from its best place (A at 80 mm) it sags by 3 mm, standing on three points "
        "(A at 1 and 40 mm and B at 60 mm) it sags by 20 mm (let settle)",
        "2 edges for each: moves by 0.1 mm"})
    CHECK_THAT(text, Contains(part));
  CHECK_THAT(text, !Contains("fails"));
  CHECK(shortfalls(fine(), terms).empty());
  CHECK(report({}, terms).empty());
}

TEST_CASE("each section fails for its own reason") {
  const auto fails = [](auto&& change) {
    Check check = fine();
    change(check);
    const auto reasons = shortfalls(check, terms);
    REQUIRE(reasons.size() == 1);
    CHECK_THAT(report(check, terms), Contains("fails: " + reasons[0] + '\n'));
    return reasons[0];
  };
  CHECK(fails([](Check& check) { check.stands->certified = false; }) ==
        "stands: it does not stand in this pose");
  CHECK(fails([](Check& check) { check.stands->rests = check.stands->certified = false; }) ==
        "stands: it was not found to come to rest");
  CHECK(fails([](Check& check) { check.stands->moved = 2; }) ==
        "stands: it comes to rest 20 mm from the file's pose");
  CHECK(fails([](Check& check) { check.stands->free_groups = {"rod A moves freely"}; }) ==
        "stands: rod A moves freely at no cost");
  CHECK(fails([](Check& check) { check.forgives->percentile_95 = 2; }) ==
        "forgives: with cables cut to 1 mm and tied to 2 mm it is within 20 mm, not the 10 mm "
        "allowed (2 times as large it would forgive them)");
  CHECK(fails([](Check& check) {
          check.forgives->percentile_95 = 2;
          check.forgives->settled = 0;
        }) ==
        "forgives: with cables cut to 1 mm and tied to 2 mm it is within 20 mm, not the 10 mm "
        "allowed (2 times as large it would forgive them, to first order)");
  CHECK(fails([](Check& check) {
          check.forgives->fallen = 7;
          check.forgives->falls_at = 0.4;
        }) ==
        "forgives: 7 of 30 fall to another pose, the first with cables cut to 0.4 mm and tied to "
        "0.8 mm (2.5 times as large it would forgive them)");
  CHECK(fails([](Check& check) { check.comes_back->pushes[0].back = 19; }) ==
        "comes back: pushed by 10 mm it comes back 19 times of 20");
  CHECK(fails([](Check& check) { check.holds->strain = 0.02; }) ==
        "holds: rod B is strained by 2 %, glass fibre bears 1 % for long");
  CHECK(fails([](Check& check) { check.holds->tension = 0.6; }) ==
        "holds: cable 5 pulls with 600 N and breaks at 500 N");
  CHECK(fails([](Check& check) { check.clear->rods->distance = -0.01; }) ==
        "clear: A at 10 and 90 mm overlap by 0.1 mm");
  CHECK(fails([](Check& check) { check.clear->cable_rod->distance = -0.01; }) ==
        "clear: cable 1 and A at 40 mm overlap by 0.1 mm");
  CHECK(fails([](Check& check) { check.converged->converged = false; }) ==
        "converged: with 2 edges for each the pose still moves by 0.1 mm");
}

TEST_CASE("the only rod of a check needs no letter") {
  CheckTerms one = terms;
  one.rods = 1;
  Check check = fine();
  check.holds->rod = 0;
  check.weight->standing->at = {{0, 1, 1}, {0, 4, 4}, {0, 6, 6}};
  CHECK_THAT(report(check, one), Contains("(20 mm along the rod; glass fibre"));
  CHECK_THAT(report(check, one), Contains("three points (10, 40 and 60 mm along the rod)"));
  check.holds->strain = 0.02;
  CHECK(shortfalls(check, one)[0].starts_with("holds: the rod is strained by 2 %"));
}

TEST_CASE("a check of rods without a shape and without cables names none") {
  Check check;
  check.holds = Holds{};
  CHECK(shortfalls(check, terms).empty());
  CHECK(report(check, terms) ==
        "holds: strain not known, for the file gives no shape of sections\n");
}

TEST_CASE("a part of a check says what it has not looked at") {
  CHECK(not_looked_at(sections(fine(), terms)).empty());
  Check part = fine();
  part.comes_back.reset();
  part.holds.reset();
  CHECK(not_looked_at(sections(part, terms)) == std::vector<std::string>{"comes back", "holds"});
  CHECK(not_looked_at({}).size() == 7);
}
