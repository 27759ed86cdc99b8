#include <catch2/catch.hpp>
#include <tencer/curves/analytic.hpp>
#include <tencer/model/scene.hpp>

using namespace tencer;

namespace {

geometry::Polyline ring(double radius, int vertices) { return curves::circle(radius, vertices); }

}  // namespace

TEST_CASE("the radius is chosen so that bends strain the rod by less than its limit") {
  // A ring of radius R bends a rod of radius r by r / R: 0.8 % of 1000 mm is 8 mm, and 6.28 mm is a
  // thousandth of the length.
  CHECK(model::chosen_radius({ring(1000, 400)}, model::glass_fibre()) == Approx(6.2));
  const model::Material aluminium = *model::find_material("aluminium");
  CHECK(model::chosen_radius({ring(1000, 400)}, aluminium) == Approx(1.9));  // below 2
  // Of two curves the tighter decides, and the longer only when no bend does.
  CHECK(model::chosen_radius({ring(1000, 400), ring(100, 400)}, model::glass_fibre()) ==
        Approx(0.79));
  const geometry::Polyline straight{.points =
                                        (Eigen::Matrix3Xd(3, 2) << 0, 1234, 0, 0, 0, 0).finished()};
  CHECK(model::chosen_radius({straight}, model::glass_fibre()) == Approx(1.2));
}

TEST_CASE("a scene is told in one line") {
  model::Scene scene = model::scene_of({ring(30, 200)}, "ring", "cm");
  CHECK(in_one_line(scene) ==
        "1 closed rod, 188.5 cm, circle r 1.8 mm, glass fibre, 36 g; fits in 60 x 60 x 0 cm");
  add_rod(scene, {.points = (Eigen::Matrix3Xd(3, 2) << 0, 10, 0, 0, 0, 31.2).finished()},
          *model::find_material("ash"));
  scene.structure.rods[1].section = der::tube(1, 0.3, 0.5, 0.4);
  scene.structure.materials[1].youngs_modulus = 4e9;
  CHECK(
      in_one_line(scene) ==
      "2 rods (1 closed), 221.3 cm, circle r 1.8 mm and tube r 5 / 4 mm, glass fibre and ash with "
      "E 4 GPa, 43 g; fits in 60 x 60 x 32 cm");
  scene.structure.rods[1].section = {.EA = 1e6};
  CHECK(in_one_line(scene) ==
        "2 rods (1 closed), 221.3 cm, circle r 1.8 mm and section by its stiffnesses, glass fibre; "
        "fits in 60 x 60 x 32 cm");
}
