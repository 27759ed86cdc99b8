#include <limits>
#include <tencer/geometry/arc_length.hpp>
#include <tencer/springs/cable.hpp>

#include "generators.hpp"

using namespace tencer;
using namespace tencer::property;

TEST_CASE("going round a closed rod leads back to the same place") {
  rc::prop("wrap(s + k L) = wrap(s), to the rounding of the sum", [] {
    const geometry::ArcLength arc(numbers(whole(3, 20), 1e-3, 1), true);
    const double length = arc.length();
    const double s = number(-5, 5) * length;
    const int turns = whole(-1000, 1000);
    const double there = arc.wrap(s);
    RC_ASSERT(there >= 0);
    RC_ASSERT(there < length);
    RC_ASSERT(arc.wrap(there) == there);
    const double apart = std::abs(arc.wrap(s + turns * length) - there);
    const double rounding =
        2 * std::numeric_limits<double>::epsilon() * (std::abs(s) + std::abs(turns) * length);
    RC_ASSERT(std::min(apart, length - apart) <= rounding);
  });
  rc::prop("wrap(s + k L) = wrap(s) exactly, where the sum is exact", [] {
    Eigen::VectorXd lengths(whole(3, 20));
    for (double& edge : lengths) edge = whole(1, 50) / 16.0;
    const geometry::ArcLength arc(lengths, true);
    const double s = whole(-5000, 5000) / 64.0;
    const int turns = whole(-1000, 1000);
    RC_ASSERT(arc.wrap(s + turns * arc.length()) == arc.wrap(s));
    const std::vector<geometry::ArcLength> rods{arc};
    const auto attached = [&](double at, geometry::Side side) {
      return springs::stencil({.a = springs::OnRod{0, at}, .b = springs::AtAnchor{0}}, rods,
                              Eigen::Vector3d::Zero(), side);
    };
    for (const auto side : {geometry::Side::after, geometry::Side::before}) {
      const auto here = attached(s, side), round = attached(s + turns * arc.length(), side);
      for (int i = 0; i < 2; ++i) {
        RC_ASSERT(here.shares[i].vertex == round.shares[i].vertex);
        RC_ASSERT(here.shares[i].weight == round.shares[i].weight);
      }
    }
  });
}
