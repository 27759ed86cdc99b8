#include <algorithm>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/fabricate/cut_list.hpp>
#include <tencer/model/units.hpp>

namespace tencer::fabricate {
namespace {

springs::End in_mm(const springs::End& end, const std::vector<geometry::ArcLength>& along,
                   double mm) {
  if (const auto* on = std::get_if<springs::OnRod>(&end))
    return springs::OnRod{on->rod, along[on->rod].wrap(on->s) * mm};
  return end;
}

double radius_at(const springs::End& end, const std::vector<RodCut>& rods) {
  const auto* on = std::get_if<springs::OnRod>(&end);
  return on ? rods[on->rod].radius : 0.0;
}

double distance_to_joint(const model::Mark& mark, const RodCut& rod) {
  const double from_end = rod.from_end(mark.s);
  return std::min(from_end, rod.length - from_end);
}

double nearest_to_joint(const RodCut& rod) {
  double nearest = rod.length;
  for (const model::Mark& mark : rod.marks)
    nearest = std::min(nearest, distance_to_joint(mark, rod));
  return nearest;
}

// Of a closed rod with marks, which are in order from its start.
void find_joint(double overlap, RodCut& rod) {
  constexpr double sleeve = 30;
  rod.nearest_mark = nearest_to_joint(rod);
  if (*rod.nearest_mark >= std::max(sleeve, overlap)) return;
  double widest = 0;
  for (std::size_t i = 0; i < rod.marks.size(); ++i) {
    const bool last = i + 1 == rod.marks.size();
    const double next = last ? rod.marks.front().s + rod.length : rod.marks[i + 1].s;
    const double gap = next - rod.marks[i].s;
    if (gap <= widest) continue;
    widest = gap;
    rod.joint = std::fmod(rod.marks[i].s + gap / 2, rod.length);
  }
  rod.nearest_mark = nearest_to_joint(rod);
  std::ranges::stable_sort(rod.marks, {},
                           [&](const model::Mark& mark) { return rod.from_end(mark.s); });
}

RodCut rod_cut(const model::Design& design, std::size_t r, std::vector<model::Mark> marks,
               double joint) {
  const der::Rod& rod = design.structure.rods[r];
  const double mm = 1000 * model::metres(design.length_unit);
  RodCut cut{.closed = rod.closed, .length = rod.length() * mm, .marks = std::move(marks)};
  cut.cut = cut.length + (rod.closed ? joint : 0.0);
  for (model::Mark& mark : cut.marks) mark.s *= mm;
  if (rod.closed && !cut.marks.empty()) find_joint(joint, cut);
  if (!design.structure.materials.empty())
    if (const auto per_metre = model::mass_per_length(design.structure.materials[r],
                                                      rod.section.shape, design.length_unit))
      cut.mass = *per_metre * cut.cut / 1000;
  return cut;
}

void validate(const Allowances& allowances) {
  for (const double length : {allowances.joint, allowances.knot})
    core::require(std::isfinite(length) && length >= 0,
                  "cut_list: allowances must be finite and not negative");
}

}  // namespace

double CutList::rods_cut() const {
  double sum = 0;
  for (const RodCut& rod : rods) sum += rod.cut;
  return sum;
}

double CutList::cables_cut() const {
  double sum = 0;
  for (const CableCut& cable : cables) sum += cable.cut;
  return sum;
}

std::optional<double> CutList::rods_mass() const {
  double sum = 0;
  for (const RodCut& rod : rods) {
    if (!rod.mass) return std::nullopt;
    sum += *rod.mass;
  }
  return sum;
}

CutList cut_list(const model::Design& design, const Allowances& allowances) {
  validate(allowances);
  const model::Structure& structure = design.structure;
  const double mm = 1000 * model::metres(design.length_unit);
  const double newtons = model::newtons(design.force_unit);
  const auto along = model::arc_lengths(structure);
  const auto radii = model::outer_radii(structure);
  auto marks = model::marks_along(structure.cables, along);
  CutList list{.allowances = allowances};
  for (std::size_t r = 0; r < structure.rods.size(); ++r) {
    list.rods.push_back(rod_cut(design, r, std::move(marks[r]), allowances.joint));
    list.rods.back().radius = radii[r] * mm;
  }
  for (std::size_t c = 0; c < structure.cables.size(); ++c) {
    const springs::Cable& cable = structure.cables[c];
    CableCut cut{.a = in_mm(cable.a, along, mm),
                 .b = in_mm(cable.b, along, mm),
                 .between_centres = design.built[c].length * mm,
                 .tension = design.built[c].tension * newtons};
    cut.between_knots =
        cut.between_centres - radius_at(cut.a, list.rods) - radius_at(cut.b, list.rods);
    cut.cut = cut.between_knots + 2 * allowances.knot;
    list.cables.push_back(cut);
  }
  return list;
}

}  // namespace tencer::fabricate
