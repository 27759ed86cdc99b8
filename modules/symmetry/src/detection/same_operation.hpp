// When two measured operations are one and the same.
#pragma once

#include <span>
#include <tencer/symmetry/operation.hpp>

namespace tencer::symmetry {

bool same_operation(const Operation& a, const Operation& b,
                    std::span<const geometry::ArcLength> rods);

}  // namespace tencer::symmetry
