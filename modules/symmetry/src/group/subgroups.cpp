#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <set>
#include <tencer/symmetry/subgroups.hpp>
#include <utility>

namespace tencer::symmetry {
namespace {

using Members = std::set<int>;

// All products of two operations; cut off when there are more than max_order.
Members made_by(int a, int b, const Group& group, int max_order) {
  Members members{0, a, b};
  std::vector<int> last(members.begin(), members.end());
  while (!last.empty() && static_cast<int>(members.size()) <= max_order) {
    std::vector<int> next;
    for (const int member : last)
      for (const int maker : {a, b})
        if (const int made = group.product(member, maker); members.insert(made).second)
          next.push_back(made);
    last = std::move(next);
  }
  return members;
}

Group part_of(const Group& group, const Members& members) {
  Group part{.rods = group.rods};
  const std::vector<int> kept(members.begin(), members.end());  // 0, the identity, is first
  part.product.resize(static_cast<Eigen::Index>(kept.size()),
                      static_cast<Eigen::Index>(kept.size()));
  for (std::size_t i = 0; i < kept.size(); ++i) {
    part.operations.push_back(group.operations[kept[i]]);
    for (std::size_t j = 0; j < kept.size(); ++j) {
      const int made = group.product(kept[i], kept[j]);
      part.product(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          static_cast<int>(std::ranges::lower_bound(kept, made) - kept.begin());
    }
  }
  return part;
}

}  // namespace

std::vector<Group> subgroups(const Group& group, int max_order) {
  std::map<std::pair<int, int>, Members> found;  // by minus the order, and proper rotations
  for (int a = 0; a < group.order(); ++a)
    for (int b = 0; b <= a; ++b) {
      Members members = made_by(a, b, group, max_order);
      const int order = static_cast<int>(members.size());
      if (order < 2 || order > max_order) continue;
      const auto proper = std::ranges::count_if(
          members, [&](int g) { return group.operations[g].matrix.determinant() > 0; });
      found.try_emplace({-order, static_cast<int>(proper)}, std::move(members));
    }
  std::vector<Group> result;
  for (const auto& [kind, members] : found) result.push_back(part_of(group, members));
  return result;
}

}  // namespace tencer::symmetry
