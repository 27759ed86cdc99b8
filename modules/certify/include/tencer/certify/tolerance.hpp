// What small errors of its cables do to a structure: the response of pose and tensions to every
// cable's length and every attachment's place, and what follows for errors within limits.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <tencer/model/state.hpp>
#include <tencer/model/view.hpp>
#include <tencer/springs/cable.hpp>
#include <tencer/springs/parameter.hpp>
#include <vector>

namespace tencer::certify {

// To first order, with inextensible cables. P parameters: the length (rest_length) of every taut
// cable, then the arc length of each of its ends that is on a rod, cable after cable.
struct [[nodiscard]] PoseResponse {
  std::vector<springs::Parameter> parameters{};
  // 3 per vertex of every rod x P: how the vertices move, aligned rigidly with the pose unless pins
  // or anchors hold the structure.
  Eigen::MatrixXd displacement{};
  Eigen::MatrixXd tension{};  // cables x P, zeros for slack cables
  bool computed = false;      // false: the pose is singular, it has no first order
};

// One factorisation and a right-hand side a parameter. At a vertex, derivatives in arc length are
// those for growing s. tensions: per cable, as the equilibrium has them. Throws
// std::invalid_argument unless there is one per cable. views: in the frame of the pose, of whose
// displacements only what they see is told; none: all of it.
PoseResponse pose_response(const model::Structure& structure, const model::State& state,
                           const Eigen::VectorXd& tensions,
                           const std::vector<model::View>& views = {});

// The largest errors, lengths: each is independent and uniform between plus and minus these.
struct CableErrors {
  double length = 0.0;      // of a cable
  double attachment = 0.0;  // of the place of an end along its rod
};

// What may be wrong of a cable, number c: its length, and where its ends are on rods.
std::vector<springs::Parameter> parameters_of(const springs::Cable& cable, int c);

// The largest error of a parameter.
double limit_of(const CableErrors& errors, const springs::Parameter& parameter);

// A row of `draws` for every parameter (P x draws): uniform in [-1, 1], the same for the same seed.
Eigen::MatrixXd unit_draws(int parameters, int draws, std::uint64_t seed);

// Without draws: the root mean square of how far errors move the vertex that they move most. Throws
// std::invalid_argument unless the response is computed.
double typical_deviation(const PoseResponse& response, const CableErrors& errors);

struct Tolerance {
  // The deviation of a draw is the largest distance of a vertex from the pose. Lengths.
  double expected = 0.0;
  double percentile_95 = 0.0;
  double worst = 0.0;       // of all draws
  int decisive_cable = -1;  // the one whose own errors move a vertex most; -1: there are none
  double decisive = 0.0;    // the root mean square of how far they do
  int first_slack = -1;     // the cable that errors let go slack first; -1: no errors do
  double slack_at = 0.0;    // by this many times the errors, all at their worst
};

// By the linear response. Throws std::invalid_argument unless the response is computed, errors are
// not negative and draws >= 1.
Tolerance tolerance(const PoseResponse& response, const Eigen::VectorXd& tensions,
                    const CableErrors& errors, int draws = 10000, std::uint64_t seed = 1);

}  // namespace tencer::certify
