#include <catch2/catch.hpp>
#include <tencer/model/scene.hpp>

using namespace tencer;

TEST_CASE("glass fibre is 40 GPa in every unit") {
  using model::glass_fibre_modulus;
  // 40 GPa = 40e9 N/m^2 = 4e6 N/cm^2 = 4e4 N/mm^2
  CHECK(glass_fibre_modulus("m", "N") == Approx(40e9).epsilon(1e-14));
  CHECK(glass_fibre_modulus("cm", "N") == Approx(4e6).epsilon(1e-14));
  CHECK(glass_fibre_modulus("mm", "N") == Approx(4e4).epsilon(1e-14));
  CHECK(glass_fibre_modulus("mm", "kN") == Approx(40).epsilon(1e-14));
  CHECK(glass_fibre_modulus("cm", "mN") == Approx(4e9).epsilon(1e-14));
  CHECK_THROWS_AS(glass_fibre_modulus("inch", "N"), std::invalid_argument);
}
