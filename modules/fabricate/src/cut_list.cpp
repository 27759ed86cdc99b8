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

RodCut rod_cut(const model::Design& design, std::size_t r, std::vector<model::Mark> marks,
               double joint) {
  const der::Rod& rod = design.structure.rods[r];
  const double mm = 1000 * model::metres(design.length_unit);
  RodCut cut{.closed = rod.closed, .length = rod.length() * mm, .marks = std::move(marks)};
  cut.cut = cut.length + (rod.closed ? joint : 0.0);
  for (model::Mark& mark : cut.marks) {
    mark.s *= mm;
    const double from_joint = std::min(mark.s, cut.length - mark.s);
    if (rod.closed) cut.nearest_mark = std::min(cut.nearest_mark.value_or(from_joint), from_joint);
  }
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
