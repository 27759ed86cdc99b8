// Whether a structure comes back when it is pushed out of its pose and let go.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <stop_token>
#include <tencer/certify/modes.hpp>
#include <tencer/model/state.hpp>
#include <vector>

namespace tencer::certify {

// A push along a combination of modes, drawn evenly, in which the vertex that moves most moves by
// `size`, a length: of the softest few modes a smooth one, of many a rough one.
struct Push {
  double size = 0.0;
  int modes = 0;  // of so many of the lowest
  std::uint64_t seed = 1;
};

// Where the structure comes to rest from there.
struct PushedRest {
  bool rests = true;       // false: it was not found where
  double deviation = 0.0;  // largest distance of a vertex from the pose, aligned as there
  double energy = 0.0;     // of rods and loads, less that at the pose
  // On the straight way out and on to where it comes to rest, two strands came nearer than they
  // move against each other in a step: one may have passed through the other.
  bool strands_met = false;
  model::State state{};
};

// tensions: per cable, as the equilibrium has them at `state`. modes: vibration_modes there. Throws
// std::invalid_argument unless size is positive and there are push.modes >= 1 modes or fewer.
PushedRest push_and_release(const model::Structure& structure, const model::State& state,
                            const VibrationModes& modes, const Push& push,
                            const std::stop_token& stop = {});

// What push_and_release() goes through, to be looked at: pushed first, at rest last, between them
// what the first steps of its solver lead to, which knows no inertia. Vertices per rod, 3 x n,
// aligned as there. Solves anew for each.
std::vector<std::vector<Eigen::Matrix3Xd>> way_of(const model::Structure& structure,
                                                  const model::State& state,
                                                  const VibrationModes& modes, const Push& push);

}  // namespace tencer::certify
