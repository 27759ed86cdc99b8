// Whether the cables that a scene allows can hold its shape: known in less than a second, before a
// search that could take minutes to find none.
#pragma once

#include <stop_token>
#include <tencer/core/error.hpp>
#include <tencer/model/feasibility.hpp>
#include <tencer/model/scene.hpp>

namespace tencer::pipeline {

// When to try what would mend it.
enum class TryMends { never, if_it_cannot, unless_it_can };

struct FeasibleOptions {
  TryMends mends = TryMends::unless_it_can;
  bool at_least = true;  // also how few cables could do, unless none can
  std::stop_token stop{};
};

// See ground_structure/feasibility.hpp. Rods of many vertices are looked at with fewer, and many
// rods first with cables between neighbours only; so many that 24 vertices of each make more than
// 700 are not looked at, and stay unclear. `cannot` is said when the rods fall by so much more than
// the error asked for that no other lengths of the cables bring them back to it: five times as far,
// and to another shape: by 2 % of the target's size, or by 10 % with a number of cables asked for,
// which may be further off. Errors: as prepare().
core::Expected<model::Feasibility> feasible(const model::Scene& scene,
                                            const FeasibleOptions& options = {});

}  // namespace tencer::pipeline
