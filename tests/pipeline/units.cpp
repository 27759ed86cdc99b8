// The same thing in other units is the same design.
#include "scenes.hpp"

using namespace tencer;

namespace {

// The scene with every length `factor` times as large a number, in the unit that makes it the same.
io::Scene in_unit(io::Scene scene, const std::string& unit, double factor) {
  scene.length_unit = unit;
  scene.anchors *= factor;
  for (io::SceneRod& rod : scene.rods) {
    rod.target.points *= factor;
    rod.section.EI *= factor * factor;
    rod.section.GJ *= factor * factor;
  }
  return scene;
}

}  // namespace

TEST_CASE("a unit that is a power of two smaller changes no bit") {
  const io::Scene scene = ellipse_scene();
  const io::Design design = designed(scene);
  const io::Design other = designed(in_unit(scene, "cm / 1024", 1024));
  REQUIRE_FALSE(design.cables.empty());
  REQUIRE(other.cables.size() == design.cables.size());
  for (std::size_t c = 0; c < design.cables.size(); ++c) {
    CHECK(other.cables[c].length == 1024 * design.cables[c].length);
    CHECK(other.cables[c].a.s == 1024 * design.cables[c].a.s);
    CHECK(other.cables[c].b.s == 1024 * design.cables[c].b.s);
    CHECK(other.cables[c].tension == design.cables[c].tension);
  }
  CHECK(other.rods[0].pose == 1024 * design.rods[0].pose);
  CHECK(other.error->max_percent == design.error->max_percent);
  CHECK(other.certificate->smallest_eigenvalue == design.certificate->smallest_eigenvalue);
}

// Rounding then differs from the first step on, and an optimizer that stops near the best
// attachments stops elsewhere near them.
TEST_CASE("a design does not depend on the unit of length") {
  const io::Scene scene = ellipse_scene();
  const io::Design in_cm = designed(scene);
  REQUIRE_FALSE(in_cm.cables.empty());
  struct Unit {
    std::string name;
    double factor;
  };
  for (const auto& [name, factor] : {Unit{"mm", 10}, Unit{"m", 0.01}}) {
    CAPTURE(name);
    const io::Design design = designed(in_unit(scene, name, factor));
    CHECK(design.length_unit == name);
    CHECK(design.status == in_cm.status);
    REQUIRE(design.cables.size() == in_cm.cables.size());
    for (std::size_t c = 0; c < design.cables.size(); ++c) {
      const io::DesignCable& cable = design.cables[c];
      const io::DesignCable& same = in_cm.cables[c];
      CHECK(cable.length == Approx(factor * same.length).epsilon(1e-6));
      CHECK(cable.a.s == Approx(factor * same.a.s).epsilon(1e-6));
      CHECK(cable.b.s == Approx(factor * same.b.s).epsilon(1e-6));
      CHECK(cable.tension == Approx(same.tension).epsilon(1e-6));
    }
    CHECK(design.error->max_percent == Approx(in_cm.error->max_percent).epsilon(1e-6));
    CHECK(design.certificate->smallest_eigenvalue ==
          Approx(in_cm.certificate->smallest_eigenvalue).epsilon(1e-6));
  }
}

TEST_CASE("a design does not depend on the unit of force") {
  const io::Scene scene = ellipse_scene();
  io::Scene in_mN = scene;
  in_mN.force_unit = "mN";
  for (io::SceneRod& rod : in_mN.rods) {
    rod.section.EA *= 1000;
    rod.section.EI *= 1000;
    rod.section.GJ *= 1000;
  }
  const io::Design design = designed(in_mN);
  const io::Design in_N = designed(scene);
  REQUIRE(design.cables.size() == in_N.cables.size());
  for (std::size_t c = 0; c < design.cables.size(); ++c) {
    CHECK(design.cables[c].tension == Approx(1000 * in_N.cables[c].tension).epsilon(1e-6));
    CHECK(design.cables[c].length == Approx(in_N.cables[c].length).epsilon(1e-6));
  }
}
