// Taking cables out of a network without losing its equilibrium.
#pragma once

#include <optional>
#include <tencer/sensitivity/tracker.hpp>
#include <tencer/sparsify/network.hpp>
#include <vector>

namespace tencer::sparsify {

// Counts of equilibrium solves, for the rows of the trace.
struct Effort {
  int solves = 0;
  int iterations = 0;
};

// How equilibria are followed while cables change. When an attachment passes a vertex the direction
// of its cable turns, so predictions are off by as much as the motion; only what would be seen in
// the shape counts as a jump. Steps are not divided: optimizers and moved() shorten their own.
sensitivity::TrackerOptions follow_options(const Control& control);

// Whether `cables`, the network's with other stiffnesses, leave its rods no more rigid motions when
// those with hardly any stiffness are left out. If they do, a rod comes loose and the solver, which
// counts cables whatever their stiffness, meets a singular matrix.
bool holds_as_before(const Network& network, const std::vector<springs::Cable>& cables);

// The network with its cables at `goal` (the same ones with other stiffness and attachments), less
// those whose stiffness is zero there: cables change in steps that the equilibrium can be followed
// along. none when it cannot.
std::optional<Network> moved(const Network& network, const std::vector<springs::Cable>& goal,
                             const Control& control, Effort& effort);

// The same with only these cables changed, to stiffness zero.
std::optional<Network> without(const Network& network, const std::vector<int>& cables,
                               const Control& control, Effort& effort);

// Takes out the cables that do not pull, until all do. none when the equilibrium is lost or no
// cable is left.
std::optional<Network> pulling_only(Network network, const Control& control, Effort& effort);

}  // namespace tencer::sparsify
