#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>
#include <tencer/model/material.hpp>

using namespace tencer;

TEST_CASE("materials are found by name, and what is said of each makes sense") {
  CHECK(model::materials().size() == 10);
  CHECK(model::glass_fibre().name == "glass fibre");
  CHECK_FALSE(model::find_material("cheese"));
  for (const model::Material& material : model::materials()) {
    INFO(material.name);
    CHECK(model::find_material(material.name)->youngs_modulus == material.youngs_modulus);
    CHECK(std::ranges::count(model::materials(), material.name, &model::Material::name) == 1);
    CHECK(material.youngs_modulus > 5e9);
    CHECK(material.youngs_modulus < 3e11);
    CHECK(*material.density > 300);
    CHECK(material.strain_limit > 0);
    CHECK(material.breaking_strain > material.strain_limit);
    CHECK_FALSE(material.source.empty());
  }
}

TEST_CASE("moduli and masses are in the units of the scene") {
  CHECK(youngs_modulus_in(model::glass_fibre(), "cm", "N") == Approx(4e6));
  CHECK(youngs_modulus_in(model::glass_fibre(), "m", "kN") == Approx(4e7));
  model::Material water{.name = "water", .density = 1000.0};
  CHECK(*mass_per_length(water, der::Circle{1.0}, "cm") == Approx(0.1 * std::numbers::pi));
  CHECK(*mass_per_length(water, der::Rectangle{20, 5}, "mm") == Approx(0.1));
  CHECK_FALSE(mass_per_length(water, {}, "cm"));
  water.density.reset();
  CHECK_FALSE(mass_per_length(water, der::Circle{1.0}, "cm"));
}
