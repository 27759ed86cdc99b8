#include "edit.hpp"

#include <algorithm>
#include <tencer/network/rest_length.hpp>
#include <tencer/pipeline/design_state.hpp>
#include <tencer/springs/law.hpp>
#include <utility>

namespace tencer::pipeline {
namespace {

bool has(const std::vector<int>& numbers, std::size_t cable) {
  return std::ranges::count(numbers, static_cast<int>(cable) + 1) > 0;
}

std::string rods_in_words(const model::Structure& structure) {
  const auto closed = std::ranges::count(structure.rods, true, &der::Rod::closed);
  return std::to_string(closed) + " closed and " +
         std::to_string(static_cast<std::ptrdiff_t>(structure.rods.size()) - closed) + " open";
}

std::optional<std::string> structure_problem(const model::Scene& scene, const model::Design& from) {
  const model::Structure& old = from.structure;
  const model::Structure& now = scene.structure;
  if (from.length_unit != scene.length_unit || from.force_unit != scene.force_unit)
    return "its units are " + from.length_unit + " and " + from.force_unit + ", the scene's " +
           scene.length_unit + " and " + scene.force_unit + "; they must be the same";
  if (!std::ranges::equal(old.rods, now.rods, {}, &der::Rod::closed, &der::Rod::closed))
    return "its rods, " + rods_in_words(old) + ", are not the scene's, " + rods_in_words(now) +
           ", one by one";
  if (old.anchors.cols() != now.anchors.cols())
    return "it has " + std::to_string(old.anchors.cols()) + " anchors, the scene " +
           std::to_string(now.anchors.cols());
  return std::nullopt;
}

// The ends of a cable of the old rods where they are on the new ones.
springs::Cable on_rods_of(const model::Structure& now, const model::Structure& old,
                          springs::Cable cable) {
  for (springs::End* end : {&cable.a, &cable.b})
    if (auto* on = std::get_if<springs::OnRod>(end))
      on->s *= now.rods[on->rod].length() / old.rods[on->rod].length();
  return cable;
}

}  // namespace

std::optional<core::Error> check_edit(const model::Scene& scene) {
  if (!scene.edit) return std::nullopt;
  const auto wrong = [&](const std::string& what) { return core::Error{scene.source, what}; };
  if (const auto problem = scene.edit->problem()) return wrong("edit." + *problem);
  if (const auto problem = structure_problem(scene, scene.edit->from))
    return wrong("edit.from: " + *problem);
  if (scene.design.cables && scene.edit->cables())
    return wrong("edit: give either design.cables or add and remove");
  if (scene.design.method != model::Method::force_balance)
    return wrong("edit: only the method force-balance goes on from a design");
  if (scene.design.symmetry == model::SymmetryUse::given ||
      scene.design.symmetry == model::SymmetryUse::detect)
    return wrong("edit: symmetries are not kept when a design is edited; use symmetry = \"none\"");
  if (scene.design.hand_over) return wrong("edit: pins cannot be handed over (design.hand_over)");
  return std::nullopt;
}

void apply_edit(model::Scene& scene) {
  if (const auto cables = scene.edit->cables()) scene.design.cables = cables;
  const model::Structure& old = scene.edit->from.structure;
  for (const int number : scene.edit->forbid)
    scene.rules.unwanted.push_back(
        on_rods_of(scene.structure, old, old.cables[static_cast<std::size_t>(number - 1)]));
}

elimination::Revision revision_of(const model::Edit& edit, const model::Scaling& scaling) {
  constexpr double slack = 1e-3;  // of the largest tension: less is taken to be as much
  const model::Design& from = edit.from;
  elimination::Revision revision;
  network::Network& network = revision.network;
  network.structure = model::scaled(from.structure, scaling);
  const std::vector<springs::Cable> cables = std::move(network.structure.cables);
  network.structure.cables.clear();
  network.state = pose_state(from, network.structure, scaling);
  double largest = 0;
  for (const auto& built : from.built) largest = std::max(largest, built.tension);
  const auto add = [&](auto&& wanted) {
    int added = 0;
    for (std::size_t c = 0; c < cables.size(); ++c) {
      if (!wanted(c)) continue;
      const double tension = std::max(from.built[c].tension, slack * largest);
      network.structure.cables.push_back(
          springs::with_tension(cables[c], from.built[c].length / scaling.scale.length,
                                tension / scaling.scale.force(), network::stiff_rest_ratio));
      ++added;
    }
    return added;
  };
  revision.kept = add([&](std::size_t c) { return has(edit.keep, c); });
  revision.going = add([&](std::size_t c) { return has(edit.forbid, c); });
  add([&](std::size_t c) { return !has(edit.keep, c) && !has(edit.forbid, c); });
  return revision;
}

}  // namespace tencer::pipeline
