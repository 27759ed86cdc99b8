// Feasibility in words.
#include <algorithm>
#include <iomanip>
#include <sstream>
#include <tencer/core/names.hpp>
#include <tencer/model/feasibility.hpp>

namespace tencer::model {
namespace {

std::string percent(double value) {
  std::ostringstream text;
  text << std::setprecision(2) << value << " %";
  return text.str();
}

std::string all_cables(const Feasibility& feasibility) {
  return feasibility.cables == 1 ? "the only cable that is allowed"
                                 : "all " + std::to_string(feasibility.cables) + " allowed cables";
}

// Where the rods went, with all cables tied.
std::string motion(const Feasibility& feasibility) {
  const bool beyond = !feasibility.rests && feasibility.verdict == Verdict::cannot;
  return "with " + all_cables(feasibility) + " tied at once the rods " +
         (beyond ? "move away by more than " : "come to rest ") + percent(feasibility.percent) +
         (beyond ? " of the target's size" : " of the target's size away");
}

// Rods that nothing keeps from the others.
std::string separation(const Feasibility& feasibility) {
  const std::vector<int>& rods = feasibility.apart;
  const bool one = rods.size() == 1;
  return core::rods_in_words(rods, feasibility.targets.size()) + (one ? " lies" : " lie") +
         " apart from the others: every cable between them draws " + (one ? "it" : "them") +
         " there, and no cable keeps " + (one ? "it" : "them") + " away";
}

}  // namespace

std::string reason(const Feasibility& feasibility) {
  const auto helps = std::ranges::find_if(feasibility.mends, &Mend::helps);
  std::string text = "cables alone cannot hold this shape: ";
  text += feasibility.apart.empty() ? "even " + motion(feasibility) + ", lengthening none"
                                    : separation(feasibility);
  if (helps != feasibility.mends.end())
    return text + "; what would: " + helps->change + " (" + percent(helps->percent) + ")";
  return text + "; nothing that was tried mends it, tencer feasible says what";
}

std::string summary(const Feasibility& feasibility) {
  const std::string asked = percent(feasibility.max_error);
  switch (feasibility.verdict) {
    case Verdict::can:
      return "can be held: " + motion(feasibility) + ", within " + asked + " of its size";
    case Verdict::unclear:
      if (feasibility.cables == 0) return "unclear: so many rods are not tied all at once";
      return "unclear: " + motion(feasibility) + ", where " + asked +
             " is asked; cables of other lengths may come closer";
    case Verdict::cannot:
      break;
  }
  if (!feasibility.apart.empty()) return "cannot be held: " + separation(feasibility);
  return "cannot be held within " + asked + " of its size: " + motion(feasibility);
}

std::string report(const Feasibility& feasibility) {
  std::ostringstream text;
  text << summary(feasibility) << '\n';
  if (feasibility.cables == 0) return text.str();
  if (feasibility.verdict == Verdict::cannot && feasibility.apart.empty())
    text << "  on the way they lose " << percent(100 * feasibility.released)
         << " of their energy, and no cable is longer there by more than "
         << percent(100 * feasibility.lengthening)
         << " of itself: whichever of them are tied, this way is open\n";
  text << "forces: tensions balance the rods at the target "
       << (feasibility.unbalanced < 1e-2 ? "" : "only ") << "but for what moves them by "
       << percent(feasibility.unbalanced) << " of the target's size, to first order\n";
  if (const std::string needed = in_words(feasibility.at_least);
      !needed.empty() && feasibility.verdict != Verdict::cannot)
    text << "number: " << needed << '\n';
  for (const std::string& warning : feasibility.warnings) text << "warning: " << warning << '\n';
  for (const Mend& mend : feasibility.mends)
    text << (mend.helps ? "would do: " : "would not do: ") << mend.change << "; the rods then rest "
         << percent(mend.percent) << " away\n";
  return text.str();
}

}  // namespace tencer::model
