// Writes designs and checks that have every key a file can have, for tests/docs/design_schema.py.
#include <cstdlib>
#include <tencer/io/design.hpp>

#include "fixtures/folder.hpp"
#include "sample_design.hpp"

using namespace tencer;
using namespace tencer::model;

namespace {

Check whole_check() {
  const Sag sag{.deviation = 0.1, .at = {{0, 1, 0.5}}};
  const LeastDistance least{.distance = -0.1, .where = "at 1 mm along the rod"};
  return {.repair = Repair{.cables = 1},
          .stands = Stands{.hertz = {1, 2}, .free_groups = {"rod B"}},
          .forgives = Forgives{.expected = no_number,
                               .percentile_95 = no_number,
                               .worst = no_number,
                               .slack_at = no_number,
                               .falls_at = 2},
          .comes_back = ComesBack{.pushes = {{.size = 1, .tried = 1}}, .others = {OtherPose{}}},
          .holds = Holds{.rod = 1, .material = "ash", .strain_limit = 0.01, .breaking_load = 560},
          .weight = OwnWeight{.hung = sag, .standing = sag},
          .clear = Clear{.rods = least, .cable_rod = least, .cables = least, .marks = least},
          .converged = Converged{.refinements = {{.times = 2}}}};
}

Design built_sample() {
  Design design = sample();
  Structure& structure = design.structure;
  structure.rods[0].section.shape = der::Tube{0.3, 0.1};
  structure.rods[1].section.shape = der::Rectangle{0.2, 0.7};
  structure.materials = {*find_material("ash"), glass_fibre()};
  design.strains = {std::nullopt, BendingStrain{0.03, 0.125, 1, structure.rods[1].length() / 2}};
  design.check = whole_check();
  return design;
}

// One way of each section that has several.
Design other_sample() {
  Design design = sample();
  design.status = DesignStatus::interrupted;
  design.structure.rods[0].section.shape = der::Circle{0.2};
  design.check = Check{.repair = Repair{},
                       .holds = Holds{.breaking_load = 560},
                       .weight = OwnWeight{.held = true, .hung = Sag{}},
                       .clear = Clear{}};
  return design;
}

}  // namespace

TEST_CASE("samples are written", "[.samples]") {
  const char* folder = std::getenv("TENCER_SAMPLES");
  REQUIRE(folder);
  const auto write = [&](const char* name, const Design& design) {
    const auto error = io::write_design(std::filesystem::path(folder) / name, design);
    if (error) FAIL(error->text());
  };
  write("built.json", built_sample());
  write("other.json", other_sample());
  Design hopeless = sample();
  hopeless.check = Check{.repair = Repair{.problem = "cables only pull"}};
  write("hopeless.json", hopeless);
}
