// What rods, cables and places are called in words for people: the same everywhere, in reports, on
// the page (whose words.js has a twin of this), in the picture and at the bench. Rods go by
// letters, so that they are not taken for the cables' numbers, which count from 1. A rod that is
// the only one is "the rod". What names a place in a file ("cables[3]") keeps the file's indices,
// which count from 0.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tencer::core {

// "A" to "Z", "AA", "AB", ...
std::string rod_name(int rod);

std::string cable_name(int cable);    // "1"
std::string anchor_name(int anchor);  // "anchor 1"

// In a sentence; `rods`: how many there are.
std::string rod_in_words(std::size_t rod, std::size_t rods);                 // "rod A", "the rod"
std::string rods_in_words(const std::vector<int>& which, std::size_t rods);  // "rods A, B and D"
std::string cable_in_words(int cable);                                       // "cable 1"

// A place on a rod, by its arc length in whatever unit is said with it.
struct Place {
  int rod = 0;
  double s = 0.0;
};

// With four digits, at least one place: "A at 83.9 cm", "A at 8.3 and 83.9 cm and B at 2 cm"; on
// the only rod "83.9 cm along the rod".
std::string places_in_words(const std::vector<Place>& places, std::size_t rods,
                            std::string_view length_unit);

}  // namespace tencer::core
