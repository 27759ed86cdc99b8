// What rods are made of, in words.
#pragma once

#include <string>
#include <string_view>
#include <tencer/model/material.hpp>

namespace tencer::model {

// "circle r 0.88 mm": in mm, or in the unit itself where that is none of units.hpp.
std::string in_words(const der::Shape& shape, std::string_view length_unit);

// Its name, with a modulus of its own where the name does not say it.
std::string in_words(const Material& material);

// "20 g", "1.25 kg"
std::string mass_in_words(double kilograms);

}  // namespace tencer::model
