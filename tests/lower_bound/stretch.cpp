#include "stretch.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace tencer::lower_bound;

namespace {

// The bend of a vertex with this moment times Voronoi length over EI.
double bend_of(double moment) {
  double bend = std::min(moment, 1.0);
  for (int k = 0; k < 50; ++k) {
    const double tan = std::tan(bend / 2);
    const double sec = 1 + tan * tan;
    bend -= (2 * tan * sec - moment) / (sec * sec + 2 * tan * tan * sec);
  }
  return bend;
}

// An elastica as the program's rods have it, of length 1 with EI = 1 and EA = slenderness: vertices
// by their balance, one after the other.
Eigen::Matrix3Xd elastica(const Eigen::VectorXd& edges, const Eigen::Vector3d& force,
                          Eigen::Vector3d moment, double slenderness) {
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, edges.size() + 1);
  Eigen::Vector3d tangent = Eigen::Vector3d::UnitX();
  moment.x() = 0;  // a rod that is free to twist has no moment along itself
  for (Eigen::Index j = 0; j < edges.size(); ++j) {
    if (j > 0) {
      const double size = moment.norm();
      const double bend = bend_of(size * (edges[j - 1] + edges[j]) / 2);
      tangent = Eigen::AngleAxisd(bend, moment / size) * tangent;
    }
    const Eigen::Vector3d edge = edges[j] * (1 + force.dot(tangent) / slenderness) * tangent;
    moment += force.cross(edge);
    x.col(j + 1) = x.col(j) + edge;
  }
  return x;
}

// The sharpest bend, and the largest strain of an edge.
struct Extremes {
  double bend = 0.0;
  double strain = 0.0;
};

Extremes extremes(const Eigen::Matrix3Xd& x, const Eigen::VectorXd& lengths) {
  Extremes most;
  for (Eigen::Index j = 0; j < lengths.size(); ++j) {
    const Eigen::Vector3d edge = x.col(j + 1) - x.col(j);
    most.strain = std::max(most.strain, std::abs(edge.norm() / lengths[j] - 1));
    if (j == 0) continue;
    const Eigen::Vector3d before = x.col(j) - x.col(j - 1);
    most.bend = std::max(most.bend, std::atan2(before.cross(edge).norm(), before.dot(edge)));
  }
  return most;
}

// What changes from place to place as a smooth target does: a sum of few waves, no longer than 1.
Eigen::Matrix3Xd waves(Eigen::Index n, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, n);
  for (int wave = 0; wave < 5; ++wave) {
    const Eigen::Vector3d a(normal(random), normal(random), normal(random));
    const double shift = normal(random);
    for (Eigen::Index i = 0; i < n; ++i)
      sum.col(i) +=
          a * std::cos(M_PI * wave * static_cast<double>(i) / static_cast<double>(n) + shift);
  }
  return sum / sum.colwise().norm().maxCoeff();
}

}  // namespace

TEST_CASE("no elastica is said to need a force, however far its target is", "[lower_bound]") {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0.7, 1.3);
  int sharp = 0;
  for (int trial = 0; trial < 36; ++trial) {
    const int edges = 20 + 10 * (trial % 5);
    Eigen::VectorXd lengths(edges);
    for (double& length : lengths) length = uniform(random);
    lengths /= lengths.sum();
    const double strength = std::pow(10.0, trial % 4 - 1);
    const auto any = [&](double size) {
      return Eigen::Vector3d(size * normal(random), size * normal(random), size * normal(random));
    };
    const double slenderness = 1e6;
    const Eigen::Matrix3Xd x = elastica(lengths, any(strength * 4), any(3), slenderness);
    const Extremes most = extremes(x, lengths);
    if (most.bend > 0.5 || most.strain > most_stretch) continue;
    for (const double error : {1e-4, 1e-3, 1e-2}) {
      INFO("trial " << trial << ", error " << error);
      const Eigen::Matrix3Xd away = waves(edges + 1, random);
      Stretch stretch{.target = x + error * away,
                      .rest_lengths = lengths,
                      .error = error,
                      .most_bend = 1.01 * most.bend,
                      .slenderness = slenderness};
      CHECK_FALSE(needs_force(stretch));
      // Twenty times as far away it may be said, and mostly is: the test can fail.
      stretch.error = error / 20;
      sharp += needs_force(stretch);
    }
  }
  CHECK(sharp > 10);
}

TEST_CASE("a stretch with a force in its middle is told where the error is small",
          "[lower_bound]") {
  // Two elasticae that meet with one moment and different forces.
  const int half = 20;
  const Eigen::VectorXd lengths = Eigen::VectorXd::Constant(half, 0.5 / half);
  const Eigen::Matrix3Xd left = elastica(lengths, {0, -20, 5}, {0, 1, 2}, 1e6);
  Eigen::Matrix3Xd both(3, 2 * half + 1);
  both.leftCols(half + 1) = left;
  // The mirror image by the plane across its start makes a rod with a force there.
  for (int i = 0; i <= half; ++i) both.col(half + i) = left.col(i);
  for (int i = 1; i <= half; ++i)
    both.col(half - i) = Eigen::Vector3d(-left(0, i), left(1, i), left(2, i));
  Stretch stretch{.target = both,
                  .rest_lengths = Eigen::VectorXd::Constant(2 * half, 0.5 / half),
                  .error = 1e-4,
                  .most_bend = 0.2,
                  .slenderness = 1e6};
  CHECK(needs_force(stretch));
  stretch.error = 0.1;
  CHECK_FALSE(needs_force(stretch));
}
