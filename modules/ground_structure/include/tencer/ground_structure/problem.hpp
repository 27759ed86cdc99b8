// What a network of cables is sought for.
#pragma once

#include <optional>
#include <tencer/model/rules.hpp>
#include <tencer/model/state.hpp>
#include <tencer/model/target.hpp>
#include <tencer/network/network.hpp>
#include <tencer/symmetry/group.hpp>
#include <vector>

namespace tencer::ground_structure {

// In scaled units (model/scaling.hpp).
struct Problem {
  model::Structure structure{};  // the rods with their supports and loads, usually without cables
  model::State start{};          // the rods at the target
  model::Target target{};
  model::Rules rules{};
  std::vector<springs::Cable> candidates{};  // as candidates() gives them
  // A group that structure, target, rules and candidates have and that networks have to keep:
  // cables then come and go in orbits.
  std::optional<symmetry::Group> symmetry{};

  network::Network bare() const { return {structure, start}; }
  const symmetry::Group* group() const { return symmetry ? &*symmetry : nullptr; }
};

}  // namespace tencer::ground_structure
