// One cable at a state: its span, and how that and its force follow from vertices and parameters.
#pragma once

#include <array>
#include <tencer/sensitivity/parameters.hpp>
#include <tencer/springs/derivatives.hpp>
#include <tencer/springs/law.hpp>

namespace tencer::sensitivity {

inline springs::Attachment attachment(springs::ParameterKind kind) {
  return kind == springs::ParameterKind::position_a ? springs::Attachment::a
                                                    : springs::Attachment::b;
}

class CableAt {
 public:
  CableAt(const equilibrium::System& system, const model::State& state, int cable)
      : system_(system),
        state_(state),
        cable_(system.structure().cables[cable]),
        stencil_(system.stencils()[cable]),
        span_(model::span_of(stencil_, state)) {}

  const springs::Cable& cable() const { return cable_; }
  const springs::Stencil& stencil() const { return stencil_; }
  const Eigen::Vector3d& span() const { return span_; }

  std::array<double, 4> rates(springs::ParameterKind kind) const {
    return springs::weight_rates(cable_, stencil_, system_.arc_lengths(), attachment(kind));
  }
  // How the span changes with s, the vertices held.
  Eigen::Vector3d span_rate(const std::array<double, 4>& rates) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = 0; i < stencil_.count; ++i) {
      const auto& share = stencil_.shares[i];
      sum += rates[i] * state_[share.rod].x.col(share.vertex);
    }
    return sum;
  }
  // Sum of weights times the vertices' entries in v, of free unknowns; held ones do not move.
  template <class Weight>
  Eigen::Vector3d moved(const Eigen::Ref<const Eigen::VectorXd>& v, Weight&& weight) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = 0; i < stencil_.count; ++i)
      for (int axis = 0; axis < 3; ++axis)
        if (const int at = unknown(i, axis); at >= 0) sum[axis] += weight(i) * v[at];
    return sum;
  }
  Eigen::Vector3d moved(const Eigen::Ref<const Eigen::VectorXd>& v) const {
    return moved(v, [&](int i) { return stencil_.shares[i].weight; });
  }
  int unknown(int share, int axis) const {
    return system_.position_index(stencil_.shares[share].rod, stencil_.shares[share].vertex, axis);
  }

  // The derivative of the force on the vertex of share i is weight force_rate + rates[i] force.
  struct ForceDerivative {
    Eigen::Vector3d force_rate = Eigen::Vector3d::Zero();
    std::array<double, 4> rates{};
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
  };
  ForceDerivative derivative(springs::ParameterKind kind) const {
    if (kind == springs::ParameterKind::stiffness)
      return {.force_rate = springs::force_by_stiffness(cable_, span_)};
    if (kind == springs::ParameterKind::rest_length)
      return {.force_rate = springs::force_by_rest_length(cable_, span_)};
    ForceDerivative result{.rates = rates(kind), .force = springs::force(cable_, span_)};
    result.force_rate =
        springs::stiffness_matrix(cable_, span_, springs::tension(cable_, span_.norm())) *
        span_rate(result.rates);
    return result;
  }

 private:
  const equilibrium::System& system_;
  const model::State& state_;
  const springs::Cable& cable_;
  const springs::Stencil& stencil_;
  Eigen::Vector3d span_;
};

}  // namespace tencer::sensitivity
