// Checks in words.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <tencer/core/names.hpp>
#include <tencer/core/words.hpp>
#include <tencer/model/certificate.hpp>
#include <tencer/model/check.hpp>
#include <tencer/model/units.hpp>
#include <utility>

namespace tencer::model {
namespace {

using core::counted;

// Lengths in mm, forces in N, three digits.
class Words {
 public:
  explicit Words(const CheckTerms& terms)
      : mm_(1000 * metres(terms.length_unit)),
        newtons_(model::newtons(terms.force_unit)),
        rods_(terms.rods) {}

  std::string mm(double length) const { return number(length * mm_) + " mm"; }
  std::string newtons(double force) const { return number(force * newtons_) + " N"; }
  std::string joules(double energy) const { return number(energy * newtons_ * mm_ / 1000) + " J"; }
  std::string rod(int rod) const { return core::rod_in_words(rod, rods_); }
  std::string places(std::vector<core::Place> places) const {
    for (core::Place& place : places) place.s *= mm_;
    return core::places_in_words(places, rods_, "mm");
  }
  static std::string percent(double fraction) { return number(100 * fraction) + " %"; }
  static std::string number(double value) {
    std::ostringstream text;
    text << std::setprecision(3) << value;
    return text.str();
  }

 private:
  double mm_;
  double newtons_;
  std::size_t rods_;
};

using Reasons = std::vector<std::string>;

void add_if(bool fails, const std::string& reason, Reasons& reasons) {
  if (fails) reasons.push_back(reason);
}

void add_shortfalls(const Stands& stands, const Words& words, Reasons& reasons) {
  add_if(stands.moved > stands.allowed,
         "stands: it comes to rest " + words.mm(stands.moved) + " from the file's pose", reasons);
  add_if(!stands.rests, "stands: it was not found to come to rest", reasons);
  add_if(stands.rests && !stands.certified, "stands: it does not stand in this pose", reasons);
  for (const std::string& group : stands.free_groups)
    reasons.push_back("stands: " + group + " at no cost");
}

void add_shortfalls(const Repair& repair, const Words&, Reasons& reasons) {
  add_if(!repair.problem.empty(), "repair: not possible: " + repair.problem, reasons);
}

// What it does is told, for people to judge.
void add_shortfalls(const OwnWeight&, const Words&, Reasons&) {}

std::string errors_words(const Forgives& forgives, double times, const Words& words) {
  return "cables cut to " + words.mm(times * forgives.length_error) + " and tied to " +
         words.mm(times * forgives.attachment_error);
}

// Errors stay what they are in a structure of another size: so many times as large it would forgive
// them.
std::string larger_words(const Forgives& forgives) {
  double times = forgives.percentile_95 / forgives.max_deviation;
  if (forgives.falls_at) times = std::max(times, 1 / *forgives.falls_at);
  if (times <= 1) return {};
  return " (" + Words::number(times) + " times as large it would forgive them" +
         (forgives.settled == 0 ? ", to first order)" : ")");
}

void add_shortfalls(const Forgives& forgives, const Words& words, Reasons& reasons) {
  add_if(forgives.percentile_95 > forgives.max_deviation,
         "forgives: with " + errors_words(forgives, 1, words) + " it is within " +
             words.mm(forgives.percentile_95) + ", not the " + words.mm(forgives.max_deviation) +
             " allowed" + larger_words(forgives),
         reasons);
  add_if(forgives.fallen > 0,
         "forgives: " + std::to_string(forgives.fallen) + " of " +
             std::to_string(forgives.settled) + (forgives.fallen == 1 ? " falls" : " fall") +
             " to another pose" +
             (forgives.falls_at
                  ? ", the first with " + errors_words(forgives, *forgives.falls_at, words) +
                        larger_words(forgives)
                  : std::string()),
         reasons);
}

void add_shortfalls(const ComesBack& comes_back, const Words& words, Reasons& reasons) {
  for (const Pushes& pushes : comes_back.pushes)
    add_if(pushes.back < pushes.tried,
           "comes back: pushed by " + words.mm(pushes.size) + " it comes back " +
               counted(pushes.back, "time") + " of " + std::to_string(pushes.tried),
           reasons);
}

void add_shortfalls(const Holds& holds, const Words& words, Reasons& reasons) {
  if (holds.rod >= 0 && holds.strain > holds.strain_limit)
    reasons.push_back("holds: " + words.rod(holds.rod) + " is strained by " +
                      Words::percent(holds.strain) + ", " + holds.material + " bears " +
                      Words::percent(holds.strain_limit) + " for long");
  if (holds.cable >= 0 && holds.tension > holds.breaking_load)
    reasons.push_back("holds: " + core::cable_in_words(holds.cable) + " pulls with " +
                      words.newtons(holds.tension) + " and breaks at " +
                      words.newtons(holds.breaking_load));
}

void add_shortfalls(const Clear& clear, const Words& words, Reasons& reasons) {
  for (const auto& least : {clear.rods, clear.cable_rod})
    if (least && least->distance <= 0)
      reasons.push_back("clear: " + least->where + " overlap by " + words.mm(-least->distance));
}

void add_shortfalls(const Converged& converged, const Words& words, Reasons& reasons) {
  if (converged.converged) return;
  const Refinement& last = converged.refinements.back();
  const std::string finer = "converged: with " + std::to_string(last.times) + " edges for each ";
  reasons.push_back(finer + (last.settles ? "the pose still moves by " + words.mm(last.moved)
                                          : "it does not come to rest"));
}

std::string line(const Repair& repair, const Words& words) {
  if (!repair.problem.empty()) return "repair: none";
  if (repair.cables == 0) return "repair: none needed, nothing moves at no cost";
  const int last = repair.first_cable + repair.cables - 1;
  return "repair: " + counted(repair.cables, "cable") + " added (" +
         core::cable_name(repair.first_cable) +
         (repair.cables > 1 ? " to " + core::cable_name(last) : std::string()) +
         "), pulling with " + words.newtons(repair.least_tension) + " to " +
         words.newtons(repair.most_tension) + "; with them the pose moves by " +
         words.mm(repair.moved);
}

std::string line(const Stands& stands, const Words& words) {
  std::string text = stands.certified ? "stands: yes" : "stands: no";
  text += ", force imbalance " + Words::number(stands.residual) + ", smallest eigenvalue " +
          Words::number(stands.smallest_eigenvalue) + " (" + eigenvalue_unit + "), " +
          std::to_string(stands.slack_cables) + " slack, at rest " + words.mm(stands.moved) +
          " from the file's pose";
  if (!stands.hertz.empty()) text += "; lowest modes";
  for (std::size_t m = 0; m < stands.hertz.size(); ++m)
    text += (m > 0 ? ", " : " ") + Words::number(stands.hertz[m]);
  if (!stands.hertz.empty()) text += " Hz";
  return text;
}

std::string line(const Forgives& forgives, const Words& words) {
  std::string text = "forgives: " + errors_words(forgives, 1, words) + ": within " +
                     words.mm(forgives.percentile_95) + " (95 %), expected " +
                     words.mm(forgives.expected) + ", worst " + words.mm(forgives.worst) + " of " +
                     std::to_string(forgives.draws) + " draws to first order";
  if (forgives.decisive_cable >= 0)
    text += "; " + core::cable_in_words(forgives.decisive_cable) + " matters most (" +
            words.mm(forgives.decisive) + ")";
  if (forgives.first_slack >= 0)
    text += "; " + core::cable_in_words(forgives.first_slack) +
            " goes slack first (errors all at their worst: " +
            errors_words(forgives, forgives.slack_at, words) + ")";
  if (forgives.settled == 0) return text;
  text += "; " + std::to_string(forgives.settled) + " let settle: worst " +
          words.mm(forgives.settled_worst) + ", " + std::to_string(forgives.fallen) +
          (forgives.fallen == 1 ? " falls; " : " fall; ");
  if (forgives.falls_up_to == 0) return text + "their paths cannot be followed";
  return text + (forgives.falls_at
                     ? "the first falls with " + errors_words(forgives, *forgives.falls_at, words)
                     : "none falls up to " + errors_words(forgives, forgives.falls_up_to, words));
}

std::string line(const ComesBack& comes_back, const Words& words) {
  std::string text = "comes back:";
  const char* separator = " ";
  for (const Pushes& pushes : comes_back.pushes) {
    text += separator + std::to_string(pushes.back) + " of " + std::to_string(pushes.tried) +
            " pushes by " + words.mm(pushes.size);
    if (pushes.lost > 0)
      text += " (" + std::to_string(pushes.lost) +
              (pushes.lost == 1 ? " comes to no rest)" : " come to no rest)");
    if (pushes.strands_met > 0)
      text += " (" + std::to_string(pushes.strands_met) +
              " of them where strands may have passed through each other)";
    separator = ", ";
  }
  constexpr std::size_t most = 3;
  for (std::size_t i = 0; i < std::min(most, comes_back.others.size()); ++i) {
    const OtherPose& other = comes_back.others[i];
    text += "; another pose " + words.mm(other.distance) + " away, " +
            words.joules(std::abs(other.energy)) + (other.energy < 0 ? " lower" : " higher") +
            ", " + counted(other.times, "time");
  }
  if (comes_back.others.size() > most)
    text += "; and " + counted(static_cast<int>(comes_back.others.size() - most), "other pose");
  return text;
}

std::string line(const Holds& holds, const Words& words) {
  std::string text = "holds: ";
  if (holds.rod >= 0)
    text += "largest strain " + Words::percent(holds.strain) + " (" +
            words.places({{holds.rod, holds.s}}) + "; " + holds.material + " bears " +
            Words::percent(holds.strain_limit) + " for long)";
  else
    text += "strain not known, for the file gives no shape of sections";
  if (holds.cable >= 0)
    text += "; largest tension " + words.newtons(holds.tension) + " (" +
            core::cable_in_words(holds.cable) + "), " +
            Words::percent(holds.tension / holds.breaking_load) + " of the breaking load " +
            words.newtons(holds.breaking_load);
  return text;
}

std::string sag_words(const Sag& sag, const Words& words) {
  std::string text = sag.falls ? "falls to another pose, " + words.mm(sag.deviation) + " away"
                               : "sags by " + words.mm(sag.deviation);
  if (sag.settled && !sag.falls) text += " (let settle)";
  return text;
}

std::string place_words(const Sag& sag, const Words& words) {
  std::vector<core::Place> places;
  for (const Sag::Support& support : sag.at) places.push_back({support.rod, support.s});
  return words.places(std::move(places));
}

std::string line(const OwnWeight& weight, const Words& words) {
  std::string text = "weight: ";
  if (weight.included) return text + "the pose has it, among the design's loads";
  text += "left out of the pose; ";
  if (!weight.hung) return text + "what it does is not known, or it swings on its supports";
  if (weight.held) return text + "as its supports hold it, it " + sag_words(*weight.hung, words);
  text += "hung from its best place (" + place_words(*weight.hung, words) + ") it " +
          sag_words(*weight.hung, words);
  return text + (weight.standing
                     ? ", standing on three points (" + place_words(*weight.standing, words) +
                           ") it " + sag_words(*weight.standing, words)
                     : std::string(", on three points it does not stand"));
}

std::string line(const Clear& clear, const Words& words) {
  std::string text = "clear:";
  const char* separator = " ";
  const auto add = [&](const std::string& what, const std::optional<LeastDistance>& least) {
    text += separator + what;
    text += least ? ' ' + words.mm(least->distance) + " (" + least->where + ')'
                  : std::string(" none near");
    separator = ", ";
  };
  add("rod to rod", clear.rods);
  add("cable to rod", clear.cable_rod);
  add("cable to cable", clear.cables);
  add("between marks", clear.marks);
  return text;
}

std::string line(const Converged& converged, const Words& words) {
  std::string text = converged.converged ? "converged: yes" : "converged: no";
  for (const Refinement& refinement : converged.refinements)
    text += ", " + std::to_string(refinement.times) + " edges for each: " +
            (refinement.settles ? "moves by " + words.mm(refinement.moved) : "no rest");
  text += "; the pose is about " + words.mm(converged.distance) + " from converged";
  return text;
}

}  // namespace

std::vector<std::string> shortfalls(const Check& check, const CheckTerms& terms) {
  const Words words(terms);
  Reasons reasons;
  if (check.repair) add_shortfalls(*check.repair, words, reasons);
  if (check.stands) add_shortfalls(*check.stands, words, reasons);
  if (check.forgives) add_shortfalls(*check.forgives, words, reasons);
  if (check.comes_back) add_shortfalls(*check.comes_back, words, reasons);
  if (check.holds) add_shortfalls(*check.holds, words, reasons);
  if (check.clear) add_shortfalls(*check.clear, words, reasons);
  if (check.converged) add_shortfalls(*check.converged, words, reasons);
  return reasons;
}

std::vector<CheckLine> sections(const Check& check, const CheckTerms& terms) {
  const Words words(terms);
  std::vector<CheckLine> result;
  const auto add = [&](const auto& section) {
    if (!section) return;
    const std::string said = line(*section, words);
    const auto colon = said.find(": ");
    Reasons reasons;
    add_shortfalls(*section, words, reasons);
    result.push_back({said.substr(0, colon), said.substr(colon + 2), !reasons.empty()});
  };
  add(check.repair);
  add(check.stands);
  add(check.forgives);
  add(check.comes_back);
  add(check.holds);
  add(check.weight);
  add(check.clear);
  add(check.converged);
  return result;
}

std::vector<std::string> not_looked_at(const std::vector<CheckLine>& lines) {
  std::vector<std::string> lacking{"stands", "forgives", "comes back", "holds",
                                   "weight", "clear",    "converged"};
  std::erase_if(lacking, [&](const std::string& section) {
    return std::ranges::count(lines, section, &CheckLine::section) > 0;
  });
  return lacking;
}

std::string lines(const Check& check, const CheckTerms& terms) {
  std::string text;
  for (const CheckLine& line : sections(check, terms))
    text += line.section + ": " + line.text + '\n';
  return text;
}

std::string report(const Check& check, const CheckTerms& terms) {
  std::string text = lines(check, terms);
  for (const std::string& reason : shortfalls(check, terms)) text += "fails: " + reason + '\n';
  return text;
}

}  // namespace tencer::model
