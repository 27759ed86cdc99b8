#include <algorithm>
#include <limits>
#include <set>
#include <tencer/fabricate/tying_order.hpp>
#include <tuple>

namespace tencer::fabricate {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// Where cables are tied already.
class Tied {
 public:
  explicit Tied(const std::vector<RodCut>& rods) : rods_(rods), at_(rods.size()) {}

  void add(const springs::End& end) {
    if (const auto* on = std::get_if<springs::OnRod>(&end)) at_[on->rod].insert(on->s);
  }

  // Along the end's rod to the nearest; infinite where there is none, and for an anchor.
  double distance(const springs::End& end) const {
    const auto* on = std::get_if<springs::OnRod>(&end);
    if (!on || at_[on->rod].empty()) return never;
    const std::set<double>& marks = at_[on->rod];
    const RodCut& rod = rods_[on->rod];
    const auto after = marks.lower_bound(on->s);
    double least = never;
    if (after != marks.end()) least = std::min(least, *after - on->s);
    if (after != marks.begin()) least = std::min(least, on->s - *std::prev(after));
    if (rod.closed) {
      least = std::min(least, rod.length - on->s + *marks.begin());
      least = std::min(least, rod.length - *marks.rbegin() + on->s);
    }
    return least;
  }

 private:
  const std::vector<RodCut>& rods_;
  std::vector<std::set<double>> at_;
};

// Its first mark: the rod, and the place on it.
std::pair<int, double> first_mark(const CableCut& cable) {
  std::pair<int, double> first{std::numeric_limits<int>::max(), 0.0};
  for (const springs::End& end : {cable.a, cable.b})
    if (const auto* on = std::get_if<springs::OnRod>(&end))
      first = std::min(first, {on->rod, on->s});
  return first;
}

}  // namespace

std::vector<int> tying_order(const CutList& list) {
  Tied tied(list.rods);
  std::vector<int> order;
  std::vector<int> left(list.cables.size());
  for (std::size_t c = 0; c < left.size(); ++c) left[c] = static_cast<int>(c);
  const auto rank = [&](int c) {
    const CableCut& cable = list.cables[c];
    const double a = tied.distance(cable.a);
    const double b = tied.distance(cable.b);
    return std::tuple(std::min(a, b), std::max(a, b), first_mark(cable), c);
  };
  while (!left.empty()) {
    const auto next = std::ranges::min_element(left, {}, rank);
    order.push_back(*next);
    tied.add(list.cables[*next].a);
    tied.add(list.cables[*next].b);
    left.erase(next);
  }
  return order;
}

}  // namespace tencer::fabricate
