// What was probably meant by a word that is not known.
#pragma once

#include <span>
#include <string_view>

namespace tencer::core {

// The known word that the fewest letters put in, left out or changed make of this one, whatever
// their case; empty when that is more than half of them.
std::string_view nearest(std::string_view word, std::span<const std::string_view> known);

}  // namespace tencer::core
