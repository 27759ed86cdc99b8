#include <catch2/catch.hpp>
#include <tencer/model/words.hpp>

using namespace tencer;

TEST_CASE("Sections are told in mm, whatever the unit of their sizes") {
  CHECK(model::in_words(der::Circle{0.088}, "cm") == "circle r 0.88 mm");
  CHECK(model::in_words(der::Tube{0.004, 0.003}, "m") == "tube r 4 / 3 mm");
  CHECK(model::in_words(der::Rectangle{10, 2.5}, "mm") == "rectangle 10 x 2.5 mm");
  CHECK(model::in_words(der::Circle{2}, "inch") == "circle r 2 inch");
  CHECK(model::in_words(der::Shape{}, "cm") == "section by its stiffnesses");
}

TEST_CASE("A material's modulus is told where its name does not tell it") {
  model::Material material = model::glass_fibre();
  CHECK(model::in_words(material) == "glass fibre");
  material.youngs_modulus = 30e9;
  CHECK(model::in_words(material) == "glass fibre with E 30 GPa");
}

TEST_CASE("Masses are told in grams, and kilograms from one on") {
  CHECK(model::mass_in_words(0.0203) == "20 g");
  CHECK(model::mass_in_words(1.25) == "1.25 kg");
}
