#include <catch2/catch.hpp>
#include <tencer/sensitivity/pose_map.hpp>

#include "fixtures.hpp"

namespace tencer::sensitivity {

TEST_CASE("the distance's gradient comes back through the pose as it does by itself") {
  for (const Example& e : examples()) {
    INFO(e.name);
    Tracker tracker = track(e);
    REQUIRE(tracker.first().usable());
    const Configuration& at = tracker.committed();
    const auto parameters = all_parameters(at.system.structure());
    const Distance d = distance(e.target, at);
    std::vector<Eigen::Matrix3Xd> rates;
    for (std::size_t r = 0; r < at.state.size(); ++r) {
      rates.push_back(Eigen::Matrix3Xd::Zero(3, at.state[r].x.cols()));
      for (int vertex = 0; vertex < at.state[r].x.cols(); ++vertex)
        for (int axis = 0; axis < 3; ++axis)
          if (const int i = at.system.position_index(static_cast<int>(r), vertex, axis); i >= 0)
            rates[r](axis, vertex) = d.gradient()[i];
    }
    const Eigen::VectorXd expected = gradient(at, parameters, adjoint(at, d));
    CHECK((pull_back(at, parameters, rates) - expected).norm() < 1e-10 * expected.norm());

    const Eigen::VectorXd change =
        Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(parameters.size()), -1, 1);
    double along = 0;  // the same change, forwards
    const auto motions = push_forward(at, parameters, change);
    for (std::size_t r = 0; r < motions.size(); ++r)
      along += motions[r].cwiseProduct(rates[r]).sum();
    CHECK(along == Approx(expected.dot(change)).epsilon(1e-8));
  }
}

TEST_CASE("gradients and changes of other sizes are refused") {
  Tracker tracker = track(examples().front());
  const Configuration& at = tracker.committed();
  const auto parameters = all_parameters(at.system.structure());
  CHECK_THROWS_AS(pull_back(at, parameters, {}), std::invalid_argument);
  CHECK_THROWS_AS(push_forward(at, parameters, Eigen::VectorXd::Zero(0)), std::invalid_argument);
}

}  // namespace tencer::sensitivity
