#include "design/design_words.hpp"

#include <iomanip>
#include <sstream>
#include <tencer/pipeline/omissions.hpp>
#include <vector>

namespace tencer::app {
namespace {

// Why a design that ran to its end is not complete.
std::string shortfall(const model::Design& design) {
  std::string text = "not complete:";
  for (const std::string& reason : model::shortfalls(design)) text += ' ' + reason + ';';
  return text + " design.json says so\n";
}

// A line each.
std::string explanation(const std::vector<pipeline::Feature>& features) {
  std::ostringstream text;
  for (const bool used : {true, false}) {
    text << (used ? "needed:\n" : "left out:\n");
    for (const auto& feature : features)
      if (feature.used == used)
        text << "  " << std::left << std::setw(19) << feature.name << ' ' << feature.why << '\n';
  }
  return text.str();
}

}  // namespace

void introduce(model::Scene& scene, const Console& console) {
  console.log()(core::Level::info, model::in_one_line(scene));
  for (const std::string& note : scene.notes) console.log()(core::Level::info, note);
  scene.notes.clear();
}

core::Expected<ExitCode> dry_run(const model::Scene& scene, const std::filesystem::path& folder,
                                 const Console& console) {
  const auto prepared = pipeline::prepare(scene);
  if (!prepared) return prepared.error();
  console.say(explanation(pipeline::features_of(scene, *prepared)) + "the result would be in " +
              folder.string() + "/; nothing was written\n");
  return ExitCode::ok;
}

std::string result_in_words(const model::Design& design, const model::Feasibility& feasible) {
  std::string text = model::summary(design);
  if (design.status == model::DesignStatus::interrupted)
    return text + "interrupted: this is the best design so far\n";
  if (design.status == model::DesignStatus::tolerance_not_reached) {
    text += shortfall(design);
    if (feasible.verdict == model::Verdict::unclear)
      text += "whether cables can hold this so closely was " + model::summary(feasible) + '\n';
  } else if (design.structure.cables.empty()) {
    text += "the rods rest in this shape by themselves\n";
  }
  return text;
}

std::string seen_in(const std::filesystem::path& folder, double seconds) {
  std::ostringstream text;
  text << std::setprecision(3) << seconds << " s in all\nsee " << (folder / "view.html").string()
       << '\n';
  return text.str();
}

}  // namespace tencer::app
