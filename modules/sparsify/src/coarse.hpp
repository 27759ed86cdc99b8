// The same problem on fewer vertices, where a search takes a fraction of the time.
#pragma once

#include <optional>
#include <tencer/sensitivity/target.hpp>
#include <tencer/sparsify/network.hpp>
#include <tencer/sparsify/rules.hpp>
#include <tencer/symmetry/group.hpp>
#include <vector>

namespace tencer::sparsify {

struct Problem {
  equilibrium::Structure structure{};  // without cables
  sensitivity::Target target{};
  Rules rules{};
  std::vector<springs::Cable> candidates{};
};

// With just as many vertices on each rod as its turns need; none when that would save little. Rods
// that need angles of twist, or are pinned other than at their ends, stay as they are.
std::optional<Problem> coarsened(const equilibrium::Structure& structure,
                                 const sensitivity::Target& target, const Rules& rules);

// The network on the rods of another resolution, cables as good as inextensible and with the same
// tensions: near an equilibrium.
Network carried(const Network& network, const equilibrium::Structure& bare);

symmetry::Group carried(const symmetry::Group& group, const std::vector<der::Rod>& from,
                        const std::vector<der::Rod>& to);

}  // namespace tencer::sparsify
