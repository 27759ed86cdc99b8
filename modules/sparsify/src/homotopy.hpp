// Cables taken out of a network gradually, so that its equilibrium can be followed.
#pragma once

#include <optional>
#include <tencer/network/stage.hpp>
#include <tencer/network/stage_recorder.hpp>
#include <tencer/sensitivity/tracker.hpp>
#include <vector>

namespace tencer::sparsify {

// How equilibria are followed while cables change. When an attachment passes a vertex the direction
// of its cable turns, so predictions are off by as much as the motion; only what would be seen in
// the shape counts as a jump. Steps are not divided: optimizers and without() shorten their own.
sensitivity::TrackerOptions follow_options(const network::Control& control);

// Whether `cables`, the network's with other stiffnesses, leave its rods no more rigid motions when
// those with hardly any stiffness are left out. If they do, a rod comes loose and the solver, which
// counts cables whatever their stiffness, meets a singular matrix.
bool holds_as_before(const network::Network& network, const std::vector<springs::Cable>& cables);

// The network without these cables: their stiffness goes to zero in steps that the equilibrium can
// be followed along. none when it cannot, or when no cable is left.
std::optional<network::Network> without(const network::Network& network,
                                        const std::vector<int>& cables,
                                        const network::Control& control,
                                        network::SolveCounts& counts);

// Takes out the cables that do not pull, until all do. none when the equilibrium is lost or no
// cable is left.
std::optional<network::Network> pulling_only(network::Network network,
                                             const network::Control& control,
                                             network::SolveCounts& counts);

}  // namespace tencer::sparsify
