// Designs to cut, in the unit that a test wants.
#pragma once

#include <tencer/der/section.hpp>
#include <tencer/model/design.hpp>
#include <tencer/model/units.hpp>

namespace tencer::fixtures {

// A closed rod of 800 mm and an open one of 300 mm, both of 2 mm radius and glass fibre, and three
// cables: 1 across the ring, 2 from the ring to the open rod, 3 from the open rod to an anchor.
inline model::Design ring_and_bar(const char* length_unit, const char* force_unit) {
  const double mm = 1e-3 / model::metres(length_unit);
  const double newton = 1 / model::newtons(force_unit);
  model::Design design;
  design.name = "ring and bar";
  design.length_unit = length_unit;
  design.force_unit = force_unit;
  const auto section = der::solid_circle(4e4 * newton / (mm * mm), 0.3, 2 * mm);
  model::Structure& structure = design.structure;
  structure.rods = {
      {.closed = true, .section = section, .rest_lengths = Eigen::VectorXd::Constant(8, 100 * mm)},
      {.closed = false,
       .section = section,
       .rest_lengths = Eigen::VectorXd::Constant(3, 100 * mm)}};
  structure.materials = {model::glass_fibre(), model::glass_fibre()};
  structure.anchors = Eigen::Matrix3Xd::Zero(3, 1);
  const auto tie = [&](const springs::End& a, const springs::End& b, double length,
                       double tension) {
    structure.cables.push_back({.a = a, .b = b});
    design.built.push_back({.length = length * mm, .tension = tension * newton});
  };
  tie(springs::OnRod{0, 550 * mm}, springs::OnRod{0, 150 * mm}, 250, 4);
  tie(springs::OnRod{0, 780 * mm}, springs::OnRod{1, 300 * mm}, 120, 2.5);
  tie(springs::AtAnchor{0}, springs::OnRod{1, 20 * mm}, 90, 1);
  return design;
}

}  // namespace tencer::fixtures
