// Energies do not depend on where a structure is, on how it is numbered, or on units.
#include <tencer/der/energy.hpp>

#include "transforms.hpp"

using namespace tencer;
using namespace tencer::property;
using equilibrium::System;
using model::State;

namespace {

constexpr double digits = 1e-11;  // of the energy, and of the largest force

void check_energy(const Posed& a, const State& at_a, const Posed& b, const State& at_b) {
  const double energy = System(a.structure).energy(at_a);
  RC_ASSERT(std::isfinite(energy));
  RC_ASSERT(std::abs(System(b.structure).energy(at_b) - energy) <= digits * (energy + 1));
}

// Of holonomies near half a turn rounding decides the sign.
bool is_clear(const State& state) {
  return std::ranges::all_of(
      state, [](const auto& rod) { return std::abs(rod.holonomy) < std::numbers::pi - 1e-6; });
}

}  // namespace

TEST_CASE("energy is the same after") {
  rc::prop("rigid motion, with which forces turn", [] {
    const Posed a = posed(rod_wish);
    const Motion by = motion();
    const Posed b = moved(a, by);
    const State here = a.state(), there = moved(here, by);
    check_energy(a, here, b, there);
    const System first(a.structure), second(b.structure);
    const Eigen::VectorXd f = first.gradient(here), g = second.gradient(there);
    for (int r = 0; r < static_cast<int>(here.size()); ++r)
      for (int i = 0; i < here[r].x.cols(); ++i) {
        const int at = first.position_index(r, i, 0);
        RC_ASSERT(largest(by.turn * f.segment<3>(at) - g.segment<3>(at)) <=
                  10 * digits * (largest(f) + 1));
      }
  });
  rc::prop("rigid motion of the curve a state is made from", [] {
    const Posed a = posed(alike_all_along);
    const State here = a.state();
    RC_PRE(is_clear(here));
    const Posed b = moved(a, motion());
    check_energy(a, here, b, b.state());
  });
  rc::prop("a closed rod starts at another vertex", [] {
    const Posed a = posed(alike_all_along);
    const State here = a.state();
    RC_PRE(is_clear(here));
    const Posed b = started_elsewhere(a);
    check_energy(a, here, b, b.state());
  });
  rc::prop("rods are numbered from their other ends", [] {
    const Posed a = posed(alike_all_along);
    const State here = a.state();
    RC_PRE(is_clear(here));
    const Posed b = reversed(a);
    check_energy(a, here, b, b.state());
  });
  rc::prop("an open strip, straight at rest, is numbered from its other end", [] {
    der::Rod forth = rod({.closed = false, .kind = RodKind::strip});
    forth.rest_curvature.resize(2, 0);
    const Eigen::Matrix3Xd x = curve(forth.rest_lengths, false, Pose::generic);
    der::RodState here = der::make_state(forth, x);
    here.theta += numbers(here.theta.size(), -0.7, 0.7);
    const der::Rod back = reversed(forth);
    der::RodState there = der::make_state(back, reversed(x, false));
    // Material frames are turned by at most half a turn, so they start near where they go.
    const auto frame = [&](int j) -> Eigen::Vector3d {
      return der::material_frame(here, forth.edges() - 1 - j).col(0);
    };
    der::set_material_frame(there, 0, frame(0));
    for (int j = 1; j < forth.edges(); ++j) {
      there.theta[j] = there.theta[j - 1];
      der::set_material_frame(there, j, frame(j));
    }
    const double energy = der::energy(forth, here);
    RC_ASSERT(std::abs(der::energy(back, there) - energy) <= digits * (energy + 1));
  });
  rc::prop("rods and cables are listed in another order", [] {
    const Posed a = posed(rod_wish);
    const auto order = order_of_rods(a);
    const State here = a.state();
    State there;
    for (const int r : order) there.push_back(here[r]);
    check_energy(a, here, listed(a, order), there);
  });
  rc::prop("lengths and moduli are given in other units, with these units", [] {
    const Posed a = posed(rod_wish);
    const Units units{.length = std::pow(10, number(-6, 6)),
                      .modulus = std::pow(10, number(-6, 12))};
    const Posed b = in_units(a, units);
    const double energy = System(a.structure).energy(a.state());
    const double there = System(b.structure).energy(b.state()) / (units.force() * units.length);
    RC_ASSERT(std::abs(there - energy) <= digits * (energy + 1));
  });
}
