// How a design is made: the choices a person has, typed, with the names that scene files, options
// of the program and documents use for them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tencer::model {

// The way to a network.
enum class Method {
  force_balance,  // tensions that balance the rods' forces at the target, then fewer cables by
                  // number
  dense_springs   // the paper's own route: dense springs, pruned, thinned, slid
};

// Who solves outer problems; which of them there are is a matter of the build.
enum class Optimizer { gauss_newton, ipopt, mma, ccsaq };

// What optimizers that use second derivatives (gauss-newton, ipopt) are given.
enum class SecondDerivatives { limited_memory, gauss_newton, exact };

// Which of the distances from the target is made small.
enum class Measure { max, rms };

// What is done about the target's symmetries.
enum class SymmetryUse {
  none,
  suggest,  // they are told
  detect,   // they are found, and orbits of cables stay together
  given     // likewise, those that the scene's generators make
};

// All values of an enumeration with their names, in the order in which they are offered.
template <class Enum>
std::span<const std::pair<Enum, std::string_view>> names();
template <>
std::span<const std::pair<Method, std::string_view>> names<Method>();
template <>
std::span<const std::pair<Optimizer, std::string_view>> names<Optimizer>();
template <>
std::span<const std::pair<SecondDerivatives, std::string_view>> names<SecondDerivatives>();
template <>
std::span<const std::pair<Measure, std::string_view>> names<Measure>();
template <>
std::span<const std::pair<SymmetryUse, std::string_view>> names<SymmetryUse>();

// The choices of a design; docs/scene.md says more of each under the name that its key has there.
struct DesignSettings {
  Method method = Method::force_balance;
  Optimizer optimizer = Optimizer::gauss_newton;
  SecondDerivatives hessian = SecondDerivatives::gauss_newton;
  double max_error = 1.0;                    // percent of the target's bounding-box diagonal
  std::optional<int> cables = std::nullopt;  // the closest design with at most so many instead
  Measure objective = Measure::max;
  SymmetryUse symmetry = SymmetryUse::suggest;
  bool hand_over = false;  // pins: to cables to the anchors, once the pinned rods are designed
  // Where work can be shared out; not set: as many as the machine has. The design is the same.
  std::optional<int> threads = std::nullopt;
  // Seconds after which the search ends with the best it has; not set: when it stops to pay.
  std::optional<double> time = std::nullopt;
  int effort = 2;  // of the search: 1 quick, 2, 3 thorough
  // Weights of the sparsity term of dense_springs, tried in this order (section 5.3).
  std::vector<double> sparsity_weights{0, 1, 10, 100, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};
  double spring_stiffness = 100;   // factor f of k = f E c^2 / L (section 5.1)
  double greedy_threshold = 5e-6;  // factor f of the threshold f L n (section 5.2)

  // What is wrong, beginning with the name of the field; not set: nothing.
  std::optional<std::string> problem() const;
};

// Why these second derivatives cannot go with the optimizer, or the method; not set when they can.
std::optional<std::string> hessian_problem(Optimizer optimizer, SecondDerivatives hessian);
std::optional<std::string> hessian_problem(Method method, SecondDerivatives hessian);

template <class Enum>
std::string_view name_of(Enum value) {
  for (const auto& [known, name] : names<Enum>())
    if (known == value) return name;
  return {};
}

// none: no value has this name.
template <class Enum>
std::optional<Enum> named(std::string_view name) {
  for (const auto& [value, known] : names<Enum>())
    if (known == name) return value;
  return std::nullopt;
}

}  // namespace tencer::model
