#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tencer/core/words.hpp>
#include <tencer/geometry/polyline.hpp>
#include <tencer/model/scene.hpp>
#include <tencer/model/units.hpp>
#include <tencer/model/words.hpp>
#include <tuple>

#include "scene/with_digits.hpp"

namespace tencer::model {
namespace {

using core::counted;

std::string rods_in_words(const Scene& scene) {
  const auto& rods = scene.structure.rods;
  const auto count = static_cast<int>(rods.size());
  const auto closed = static_cast<int>(std::ranges::count(rods, true, &der::Rod::closed));
  const std::string length =
      with_digits(total_length(scene.structure), 4) + ' ' + scene.length_unit;
  if (closed == count) return counted(count, "closed rod") + ", " + length;
  if (closed == 0) return counted(count, "open rod") + ", " + length;
  return counted(count, "rod") + " (" + std::to_string(closed) + " closed), " + length;
}

// A program's scene may be in a unit of its own, of which no size in metres is known.
bool known_unit(const Scene& scene) {
  return std::ranges::find(length_units(), scene.length_unit) != length_units().end();
}

// What there is to say of each rod, each once.
template <class Say>
std::string said_once(std::size_t rods, const Say& say) {
  std::vector<std::string> words;
  for (std::size_t r = 0; r < rods; ++r)
    if (const std::string word = say(r);
        !word.empty() && std::ranges::find(words, word) == words.end())
      words.push_back(word);
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " and ") + word;
  return text;
}

std::optional<std::string> mass_of_rods(const Scene& scene) {
  if (!known_unit(scene)) return std::nullopt;
  double mass = 0;
  for (std::size_t r = 0; r < scene.structure.rods.size(); ++r) {
    const der::Rod& rod = scene.structure.rods[r];
    const auto per_length =
        mass_per_length(scene.structure.materials[r], rod.section.shape, scene.length_unit);
    if (!per_length) return std::nullopt;
    mass += *per_length * rod.length() * metres(scene.length_unit);
  }
  return mass_in_words(mass);
}

std::string box_in_words(const Scene& scene) {
  Eigen::AlignedBox3d box;
  for (const auto& points : scene.target.points)
    for (const auto& point : points.colwise()) box.extend(Eigen::Vector3d(point));
  Eigen::Vector3d sizes = box.sizes();
  std::ranges::sort(sizes, std::greater{});
  std::string text;
  // Rounded up, all to the same place: the second digit of the largest.
  const double place = std::pow(10.0, std::floor(std::log10(sizes[0])) - 1);
  for (const double size : sizes)
    text += (text.empty() ? "" : " x ") +
            with_digits(std::max(0.0, std::ceil(size / place - 1e-6)) * place, 2);
  return text + ' ' + scene.length_unit;
}

}  // namespace

std::string in_one_line(const Scene& scene) {
  const auto& rods = scene.structure.rods;
  const auto& materials = scene.structure.materials;
  std::string text = rods_in_words(scene) + ", " + said_once(rods.size(), [&](std::size_t r) {
                       return in_words(rods[r].section.shape, scene.length_unit);
                     });
  if (!materials.empty()) {
    // Stiffnesses are not those of a material.
    const std::string made_of = said_once(rods.size(), [&](std::size_t r) {
      return der::area(rods[r].section.shape) ? in_words(materials[r]) : "";
    });
    if (!made_of.empty()) text += ", " + made_of;
    if (const auto mass = mass_of_rods(scene)) text += ", " + *mass;
  }
  return text + "; fits in " + box_in_words(scene);
}

}  // namespace tencer::model
