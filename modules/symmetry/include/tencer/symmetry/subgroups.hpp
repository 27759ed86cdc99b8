// The smaller symmetries within a symmetry.
#pragma once

#include <tencer/symmetry/group.hpp>
#include <vector>

namespace tencer::symmetry {

// Subgroups of more than one and at most `max_order` operations that two of their operations make,
// the group itself among them; of those with as many rotations and as many other operations only
// one. The largest first.
std::vector<Group> subgroups(const Group& group, int max_order);

}  // namespace tencer::symmetry
