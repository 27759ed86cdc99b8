// Whether a network, once it is built, comes to rest in the pose that it was designed for.
#pragma once

#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/model/target.hpp>
#include <tencer/network/network.hpp>

namespace tencer::network {

// The network with cables that can neither stretch nor push, each as long as it is at the network's
// state.
model::Structure built(const Network& network);

struct [[nodiscard]] Settling {
  equilibrium::Equilibrium equilibrium{};
  // How far its vertices are from the network's state, in % of the target's diagonal, aligned
  // unless the structure is held in space.
  double moved_percent = 0.0;

  // Whether it comes to rest where the network is, to 0.01 % of the target's size.
  bool in_pose() const { return equilibrium.usable() && moved_percent <= 0.01; }
};

// Lets the built network go at `start`, usually the rods at the target.
Settling settle(const Network& network, model::State start, const model::Target& target,
                const equilibrium::SolveOptions& options = {});

}  // namespace tencer::network
