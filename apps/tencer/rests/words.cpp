#include "rests/words.hpp"

#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>
#include <tencer/core/words.hpp>
#include <tencer/model/units.hpp>

namespace tencer::app {
namespace {

using rehearsal::DesignPass;
using rehearsal::DesignRest;
using rehearsal::DesignRests;

// In mm and mJ.
class Units {
 public:
  explicit Units(const DesignRests& found) {
    const model::Design& design = found.rests[0].design;
    millimetres_ = 1e3 * model::metres(design.length_unit);
    millijoules_ = millimetres_ * model::newtons(design.force_unit);
  }
  double length(double value) const { return millimetres_ * value; }
  double energy(double value) const { return millijoules_ * value; }

 private:
  double millimetres_ = 1.0;
  double millijoules_ = 1.0;
};

std::string digits(double value) {
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

std::string rest_name(int i) { return "rest " + std::to_string(i + 1); }

const DesignRest& rest(const DesignRests& found, int i) {
  return found.rests[static_cast<std::size_t>(i)];
}

std::string table(const DesignRests& found, const Units& units) {
  std::ostringstream text;
  text << "  rest  energy, mJ  off target, mm  from rest 1, mm  softest  ended here\n";
  for (std::size_t i = 0; i < found.rests.size(); ++i) {
    const DesignRest& at = found.rests[i];
    text << std::setw(6) << i + 1 << std::setw(12) << digits(units.energy(at.energy))
         << std::setw(16) << digits(units.length(at.off_target)) << std::setw(17)
         << digits(units.length(at.away)) << std::setw(9) << digits(at.softest) << std::setw(12)
         << at.found << '\n';
  }
  return text.str();
}

std::string strands(const DesignPass& pass, const Units& units) {
  if (pass.strands_met) return "strands pass through each other, so no hand can take it that way";
  if (pass.strands_apart < 0)
    return "strands overlap by " + digits(units.length(-pass.strands_apart)) +
           " mm, so no hand can take it that way";
  if (pass.cable_in_rod)
    return "cable " + std::to_string(*pass.cable_in_rod + 1) + " goes through a rod";
  if (!std::isfinite(pass.strands_apart)) return "free: no strands come near each other";
  return "free: strands stay " + digits(units.length(pass.strands_apart)) + " mm apart at least";
}

std::string in_words(const DesignRests& found, const DesignPass& pass, const Units& units) {
  const double up = pass.energy - rest(found, pass.from).energy;
  const double back = pass.energy - rest(found, pass.to).energy;
  return "  from " + rest_name(pass.from) + " to " + rest_name(pass.to) + ": " +
         digits(units.energy(up)) + " mJ up, " + digits(units.energy(back)) +
         " mJ on the way back; " + strands(pass, units) + '\n';
}

// What keeps the design in its own pose.
std::string barrier(const DesignRests& found, const Units& units) {
  const auto leads_out = [](const DesignPass& pass) { return pass.from == 0 || pass.to == 0; };
  for (const DesignPass& pass : found.passes)
    if (leads_out(pass))
      return "The lowest pass that was found out of rest 1 is " +
             digits(units.energy(pass.energy - found.rests[0].energy)) + " mJ above it.\n";
  return {};
}

// Rests that no passes lead to.
std::string without_pass(const DesignRests& found) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i < found.rests.size(); ++i)
    if (found.ways[i].empty()) names.push_back(rest_name(static_cast<int>(i)));
  if (names.empty()) return {};
  return "No pass was found to " + core::listed(names) +
         ": how much has to be lifted on the way there is not known.\n";
}

nlohmann::json number(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

}  // namespace

std::string label_of(const DesignPass& pass, std::size_t pose) {
  const auto percent =
      std::lround(100.0 * static_cast<double>(pose) /
                  static_cast<double>(std::max<std::size_t>(1, pass.way.size() - 1)));
  return rest_name(pass.from) + " to " + rest_name(pass.to) + ", " + std::to_string(percent) +
         " %" + (static_cast<int>(pose) == pass.top ? ": the pass" : "");
}

std::string in_words(const DesignRests& found) {
  const Units units(found);
  const auto count = static_cast<int>(found.rests.size());
  std::string text = (count == 1 ? "One rest was found, the design's own, in "
                                 : core::counted(count, "rest") + " were found, in ") +
                     std::to_string(found.pushes) + " pushes; the design's own is rest 1.\n";
  text += table(found, units);
  for (const DesignPass& pass : found.passes) text += in_words(found, pass, units);
  text += barrier(found, units) + without_pass(found);
  if (found.lost > 0)
    text +=
        std::to_string(found.lost) + " of the pushes ended in no stable pose that could be told.\n";
  return text;
}

std::string rests_json(const DesignRests& found) {
  const Units units(found);
  nlohmann::ordered_json all{{"length_unit", "mm"},
                             {"energy_unit", "mJ"},
                             {"pushes", found.pushes},
                             {"lost", found.lost},
                             {"passes_missed", found.passes_missed},
                             {"finished", found.finished}};
  all["rests"] = nlohmann::ordered_json::array();
  for (const DesignRest& at : found.rests)
    all["rests"].push_back({{"energy", units.energy(at.energy)},
                            {"off_target", units.length(at.off_target)},
                            {"from_rest_1", units.length(at.away)},
                            {"smallest_eigenvalue", at.softest},
                            {"ended_here", at.found}});
  all["passes"] = nlohmann::ordered_json::array();
  for (const DesignPass& pass : found.passes) {
    nlohmann::ordered_json energies = nlohmann::ordered_json::array();
    for (const double energy : pass.energies) energies.push_back(units.energy(energy));
    all["passes"].push_back({{"from", pass.from + 1},
                             {"to", pass.to + 1},
                             {"energy", units.energy(pass.energy)},
                             {"free", pass.free()},
                             {"strands_apart", number(units.length(pass.strands_apart))},
                             {"strands_met", pass.strands_met},
                             {"energies", energies},
                             {"top", pass.top}});
  }
  return all.dump(2) + '\n';
}

}  // namespace tencer::app
