// The same thing in other units is the same design.
#include "scenes.hpp"

using namespace tencer;

namespace {

// The scene with every length `factor` times as large a number, in the unit that makes it the same.
model::Scene in_unit(model::Scene scene, const std::string& unit, double factor) {
  scene.length_unit = unit;
  model::Structure& structure = scene.structure;
  structure.anchors *= factor;
  for (std::size_t r = 0; r < structure.rods.size(); ++r) {
    retarget(scene, r, factor * scene.target.points[r]);
    der::Section& section = structure.rods[r].section;
    for (double* stiffness : {&section.EI1, &section.EI2, &section.GJ})
      *stiffness *= factor * factor;
    section.shape = der::resized(section.shape, factor);
  }
  return scene;
}

// Where the ends of a cable are.
double place_a(const model::Design& design, std::size_t cable) {
  return std::get<springs::OnRod>(design.structure.cables[cable].a).s;
}
double place_b(const model::Design& design, std::size_t cable) {
  return std::get<springs::OnRod>(design.structure.cables[cable].b).s;
}

}  // namespace

TEST_CASE("a unit that is a power of two smaller changes no bit") {
  model::Scene scene = ellipse_scene();
  scene.build.length_error = scene.build.attachment_error = 0;  // not known in another unit
  const model::Design design = designed(scene);
  const model::Design other = designed(in_unit(scene, "cm / 1024", 1024));
  REQUIRE_FALSE(design.structure.cables.empty());
  REQUIRE(other.structure.cables.size() == design.structure.cables.size());
  for (std::size_t c = 0; c < design.built.size(); ++c) {
    CHECK(other.built[c].length == 1024 * design.built[c].length);
    CHECK(place_a(other, c) == 1024 * place_a(design, c));
    CHECK(place_b(other, c) == 1024 * place_b(design, c));
    CHECK(other.built[c].tension == design.built[c].tension);
  }
  CHECK(other.pose[0] == 1024 * design.pose[0]);
  CHECK(other.error->max_percent == design.error->max_percent);
  CHECK(other.certificate->smallest_eigenvalue == design.certificate->smallest_eigenvalue);
}

// Rounding then differs from the first step on, and an optimizer that stops near the best
// attachments stops elsewhere near them.
TEST_CASE("a design does not depend on the unit of length") {
  const model::Scene scene = ellipse_scene();
  const model::Design in_cm = designed(scene);
  REQUIRE_FALSE(in_cm.built.empty());
  struct Unit {
    std::string name;
    double factor;
  };
  for (const auto& [name, factor] : {Unit{"mm", 10}, Unit{"m", 0.01}}) {
    CAPTURE(name);
    const model::Design design = designed(in_unit(scene, name, factor));
    CHECK(design.length_unit == name);
    CHECK(design.status == in_cm.status);
    REQUIRE(design.built.size() == in_cm.built.size());
    for (std::size_t c = 0; c < design.built.size(); ++c) {
      CHECK(design.built[c].length == Approx(factor * in_cm.built[c].length).epsilon(1e-6));
      CHECK(place_a(design, c) == Approx(factor * place_a(in_cm, c)).epsilon(1e-6));
      CHECK(place_b(design, c) == Approx(factor * place_b(in_cm, c)).epsilon(1e-6));
      CHECK(design.built[c].tension == Approx(in_cm.built[c].tension).epsilon(1e-6));
    }
    CHECK(design.error->max_percent == Approx(in_cm.error->max_percent).epsilon(1e-6));
    CHECK(design.certificate->smallest_eigenvalue ==
          Approx(in_cm.certificate->smallest_eigenvalue).epsilon(1e-6));
  }
}

TEST_CASE("a design does not depend on the unit of force") {
  const model::Scene scene = ellipse_scene();
  model::Scene in_mN = scene;
  in_mN.force_unit = "mN";
  for (der::Rod& rod : in_mN.structure.rods)
    for (double* stiffness : {&rod.section.EA, &rod.section.EI1, &rod.section.EI2, &rod.section.GJ})
      *stiffness *= 1000;
  const model::Design design = designed(in_mN);
  const model::Design in_N = designed(scene);
  REQUIRE(design.built.size() == in_N.built.size());
  for (std::size_t c = 0; c < design.built.size(); ++c) {
    CHECK(design.built[c].tension == Approx(1000 * in_N.built[c].tension).epsilon(1e-6));
    CHECK(design.built[c].length == Approx(in_N.built[c].length).epsilon(1e-6));
  }
}
