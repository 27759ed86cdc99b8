// Fewer cables by number: out of a network that holds the target, one cable after another, all
// others refitted (the paper's open problem of asking for a number of cables, section 6.3).
#pragma once

#include <span>
#include <tencer/sensitivity/target.hpp>
#include <tencer/sparsify/network.hpp>
#include <tencer/sparsify/rules.hpp>
#include <tencer/symmetry/group.hpp>
#include <vector>

namespace tencer::sparsify {

enum class Measure { largest, rms };  // of the distances from the target

struct ThinOptions {
  double max_percent = 1.0;  // the largest distance from the target that is accepted
  // The best network with at most so many cables, however far from the target; 0: the fewest cables
  // within max_percent.
  int cables = 0;
  bool every_number = false;  // fits the network of every number of cables on the way
  Measure measure = Measure::largest;
  // Softer networks are not entered (in the units of equilibrium::Stability): designs that fit ever
  // better by getting ever softer would not survive being built. A free straight rod has 500.
  // Networks that are softer at the start are held to a fifth of what they have.
  double least_eigenvalue = 500.0;
  int threads = 2;  // the result does not depend on it
};

// Throws std::invalid_argument, naming the field, unless the numbers make sense.
void validate(const ThinOptions& options);

struct Choice {
  Network network{};
  double max_percent = 0.0;
  double rms_percent = 0.0;
  double smallest_eigenvalue = 0.0;  // with cables as good as inextensible
  bool settles = false;  // as built, and let go at the target, it comes to rest in this pose
};

struct ThinResult {
  StageResult stage{};
  // Networks found and fitted, the fewest cables first, each closer to the target than all with
  // fewer cables.
  std::vector<Choice> choices{};
};

// Several descents, each with another balance between closeness and stability, are made side by
// side. In each, the cable goes whose loss is predicted to cost least once the others have been
// refitted (to first order), gradually where it cannot go at once; attachments slide, cables stay
// as good as inextensible. The best networks are fitted closely, then varied: one of `candidates`
// goes in where it helps most, and others out. Requires a stable equilibrium in which every cable
// pulls. symmetry: null, or a group that the structure, the target and the network have; orbits of
// cables then stay together.
ThinResult thin(const Network& network, const sensitivity::Target& target, const Rules& rules,
                std::span<const springs::Cable> candidates, const symmetry::Group* symmetry,
                const ThinOptions& options = {}, const Control& control = {});

}  // namespace tencer::sparsify
