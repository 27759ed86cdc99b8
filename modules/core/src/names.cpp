#include <sstream>
#include <tencer/core/error.hpp>
#include <tencer/core/names.hpp>
#include <tencer/core/words.hpp>

namespace tencer::core {

std::string rod_name(int rod) {
  require(rod >= 0, "rod_name: a rod's index is not negative");
  const std::string last(1, static_cast<char>('A' + rod % 26));
  return rod < 26 ? last : rod_name(rod / 26 - 1) + last;
}

std::string cable_name(int cable) { return std::to_string(cable + 1); }

std::string anchor_name(int anchor) { return "anchor " + std::to_string(anchor + 1); }

std::string rod_in_words(std::size_t rod, std::size_t rods) {
  return rods_in_words({static_cast<int>(rod)}, rods);
}

std::string rods_in_words(const std::vector<int>& which, std::size_t rods) {
  if (rods == 1) return "the rod";
  std::vector<std::string> names;
  for (const int rod : which) names.push_back(rod_name(rod));
  return (which.size() == 1 ? "rod " : "rods ") + listed(names);
}

std::string cable_in_words(int cable) { return "cable " + cable_name(cable); }

std::string places_in_words(const std::vector<Place>& places, std::size_t rods,
                            std::string_view length_unit) {
  std::vector<std::string> told;
  for (std::size_t i = 0; i < places.size();) {
    const int rod = places[i].rod;
    std::vector<std::string> lengths;
    for (; i < places.size() && places[i].rod == rod; ++i) {
      std::ostringstream length;
      length.precision(4);
      length << places[i].s;
      lengths.push_back(length.str());
    }
    const std::string along = listed(lengths) + ' ' + std::string(length_unit);
    told.push_back(rods == 1 ? along + " along the rod" : rod_name(rod) + " at " + along);
  }
  return listed(told);
}

}  // namespace tencer::core
