// Designs in words.
#include <algorithm>
#include <iomanip>
#include <sstream>
#include <tencer/core/words.hpp>
#include <tencer/model/build.hpp>
#include <tencer/model/design.hpp>
#include <tencer/model/target.hpp>
#include <tencer/model/units.hpp>

namespace tencer::model {
namespace {

using core::counted;

double millimetres(const Design& design, double length) {
  return 1000 * metres(design.length_unit) * length;
}

// ", max error 4.25 mm, rms 2.8 mm (0.639 % and 0.45 % of the target's size)", in mm where the unit
// is known.
std::string error_words(const Design& design) {
  if (!design.error) return "";
  const auto [max_percent, rms_percent] = *design.error;
  std::ostringstream text;
  text << std::setprecision(3);
  if (std::ranges::count(length_units(), design.length_unit) == 0) {
    text << ", max error " << max_percent << " %, rms " << rms_percent << " % of the target's size";
  } else {
    const double one_percent = millimetres(design, diagonal({.points = design.target})) / 100;
    text << ", max error " << max_percent * one_percent << " mm, rms " << rms_percent * one_percent
         << " mm (" << max_percent << " % and " << rms_percent << " % of the target's size)";
  }
  if (!design.views.empty()) text << ", " << seen_in_words(design.views);
  return text.str();
}

// What the plain words of summary() leave out.
std::string certificate_words(const Certificate& certificate) {
  std::ostringstream text;
  text << std::setprecision(3) << "certificate: force imbalance " << certificate.residual
       << ", smallest eigenvalue " << certificate.smallest_eigenvalue << " (" << eigenvalue_unit
       << ")\n";
  return text.str();
}

std::string status_words(DesignStatus status) {
  switch (status) {
    case DesignStatus::complete:
      return "complete";
    case DesignStatus::tolerance_not_reached:
      return "not complete";
    case DesignStatus::interrupted:
      return "interrupted";
  }
  return {};
}

std::string goal_words(const Goal& goal) {
  std::ostringstream text;
  text << std::setprecision(3);
  if (goal.by_number())
    text << "the closest design with at most " << counted(goal.cables, "cable");
  else
    text << "the fewest cables within " << goal.max_error_percent << " % of the target's size";
  return text.str();
}

std::string stage_table(const std::vector<StageRow>& trace) {
  std::ostringstream text;
  text << std::left << std::setw(12) << "stage" << std::right << std::setw(9) << "seconds"
       << std::setw(8) << "cables" << std::setw(10) << "max %" << std::setw(10) << "rms %"
       << std::setw(8) << "solves"
       << "  note\n"
       << std::setprecision(3);
  for (const StageRow& row : trace)
    text << std::left << std::setw(12) << row.stage << std::right << std::setw(9) << row.seconds
         << std::setw(8) << row.cables << std::setw(10) << row.max_percent << std::setw(10)
         << row.rms_percent << std::setw(8) << row.solves << "  " << row.note << '\n';
  return text.str();
}

}  // namespace

std::vector<std::string> shortfalls(const Design& design) {
  std::vector<std::string> reasons;
  const auto add = [&](bool holds, const std::string& reason) {
    if (holds) reasons.push_back(reason);
  };
  if (design.goal && design.error && !design.goal->met(score_of(design))) {
    std::ostringstream text;
    if (design.goal->by_number())
      text << "it has " << counted(static_cast<int>(design.built.size()), "cable")
           << ": none was found with " << design.goal->cables << " or fewer";
    else
      text << "the max error is above the " << design.goal->max_error_percent << " % asked for";
    reasons.push_back(text.str());
  }
  for (std::size_t r = 0; r < design.strains.size(); ++r)
    if (auto problem = bend_problem(design.structure, r, design.target[r], design.strains[r],
                                    design.length_unit))
      reasons.push_back(std::move(*problem));
  if (!design.certificate) return reasons;
  const Certificate& certificate = *design.certificate;
  add(!certificate.stable, "it does not stand");
  add(certificate.floating_components > 1, "nothing ties its " +
                                               std::to_string(certificate.floating_components) +
                                               " groups of rods to each other");
  add(!certificate.settles_from_target.value_or(true),
      "let go at the target it comes to rest elsewhere");
  if (design.check)
    for (std::string& reason : shortfalls(*design.check, terms_of(design)))
      reasons.push_back(std::move(reason));
  return reasons;
}

CheckTerms terms_of(const Design& design) {
  return {.length_unit = design.length_unit,
          .force_unit = design.force_unit,
          .rods = design.structure.rods.size()};
}

std::string summary(const Design& design) {
  std::ostringstream text;
  const auto cables = static_cast<int>(design.structure.cables.size());
  const int external = external_cables(design);
  text << counted(cables, "cable");
  if (design.structure.anchors.cols() > 0)
    text << " (" << cables - external << " internal, " << external << " external)";
  text << error_words(design) << '\n';
  if (design.at_least && design.at_least->cables > 0) text << in_words(*design.at_least) << '\n';
  if (!design.certificate) return text.str();
  const Certificate& certificate = *design.certificate;
  text << (certificate.stable ? "stands" : "does not stand");
  if (certificate.settles_from_target)
    text << (*certificate.settles_from_target
                 ? ": let go at the target it comes to rest in this pose"
                 : ": let go at the target it comes to rest elsewhere");
  text << ", " << counted(certificate.slack_cables, "slack cable") << '\n' << std::setprecision(3);
  if (certificate.off_by_errors && !design.check)
    text << "cables cut to " << usual_length_error_mm << " mm and tied to "
         << usual_attachment_error_mm << " mm: off by about "
         << millimetres(design, *certificate.off_by_errors) << " mm (tencer check tells more)\n";
  if (!design.check)
    text << (design.structure.line_loads.empty()
                 ? "weight: left out of the pose (tencer check tells what it does)\n"
                 : "weight: the pose has it, among the design's loads\n");
  if (design.check) text << lines(*design.check, terms_of(design));
  return text.str();
}

std::string Design::brief_report() const {
  std::ostringstream text;
  text << std::setprecision(3) << (name.empty() ? "design" : name) << ": " << status_words(status)
       << ", " << counted(static_cast<int>(structure.cables.size()), "cable");
  if (error) text << ", max error " << error->max_percent << " %";
  if (certificate) {
    text << (certificate->stable ? ", stands" : ", does not stand");
    if (certificate->off_by_errors)
      text << ", off by about " << millimetres(*this, *certificate->off_by_errors)
           << " mm when cut to " << usual_length_error_mm << " mm";
    if (certificate->settles_from_target)
      text << (*certificate->settles_from_target ? ", settles from the target"
                                                 : ", settles elsewhere");
  }
  return text.str();
}

std::string findings(const Design& design) {
  std::string text =
      (design.name.empty() ? "design" : design.name) + ": " + status_words(design.status) + '\n';
  if (design.goal) text += "asked for: " + goal_words(*design.goal) + '\n';
  for (const std::string& reason : shortfalls(design)) text += "falls short: " + reason + '\n';
  if (design.status == DesignStatus::interrupted)
    text += "interrupted: this is the best design so far\n";
  else if (design.structure.cables.empty() && design.complete())
    text += "the rods rest in this shape by themselves\n";
  text += summary(design);
  return design.certificate ? text + certificate_words(*design.certificate) : text;
}

std::string Design::full_report() const {
  return findings(*this) + (trace.empty() ? std::string() : stage_table(trace));
}

}  // namespace tencer::model
