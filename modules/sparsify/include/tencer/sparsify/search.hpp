// Few cables without a network to start from: the forces balanced at the target, then thinned, on
// fewer vertices first where that saves time.
#pragma once

#include <span>
#include <tencer/sparsify/thin.hpp>

namespace tencer::sparsify {

// `bare`: the rods without cables, at the target. symmetry: null, or a group of structure and
// target that the result must have. hints: groups that structure and target nearly have; some
// networks are given them to begin with, since symmetric networks are found sooner and are often
// good. The result need not have them. Not looked at when `symmetry` is given.
ThinResult search(const Network& bare, const sensitivity::Target& target, const Rules& rules,
                  std::span<const springs::Cable> candidates, const symmetry::Group* symmetry,
                  std::span<const symmetry::Group> hints, const ThinOptions& options = {},
                  const Control& control = {});

}  // namespace tencer::sparsify
