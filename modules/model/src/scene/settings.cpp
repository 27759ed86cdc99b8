#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <tencer/model/settings.hpp>

namespace tencer::model {

template <class Enum>
using Named = std::pair<Enum, std::string_view>;

template <>
std::span<const Named<Method>> names<Method>() {
  static constexpr std::array<Named<Method>, 2> all{
      {{Method::force_balance, "force-balance"}, {Method::dense_springs, "dense-springs"}}};
  return all;
}

template <>
std::span<const Named<Optimizer>> names<Optimizer>() {
  static constexpr std::array<Named<Optimizer>, 4> all{{{Optimizer::gauss_newton, "gauss-newton"},
                                                        {Optimizer::ipopt, "ipopt"},
                                                        {Optimizer::mma, "mma"},
                                                        {Optimizer::ccsaq, "ccsaq"}}};
  return all;
}

template <>
std::span<const Named<SecondDerivatives>> names<SecondDerivatives>() {
  static constexpr std::array<Named<SecondDerivatives>, 3> all{
      {{SecondDerivatives::limited_memory, "limited-memory"},
       {SecondDerivatives::gauss_newton, "gauss-newton"},
       {SecondDerivatives::exact, "exact"}}};
  return all;
}

template <>
std::span<const Named<Measure>> names<Measure>() {
  static constexpr std::array<Named<Measure>, 2> all{
      {{Measure::max, "max"}, {Measure::rms, "rms"}}};
  return all;
}

template <>
std::span<const Named<SymmetryUse>> names<SymmetryUse>() {
  static constexpr std::array<Named<SymmetryUse>, 4> all{{{SymmetryUse::none, "none"},
                                                          {SymmetryUse::suggest, "offer"},
                                                          {SymmetryUse::detect, "detect"},
                                                          {SymmetryUse::given, "given"}}};
  return all;
}

std::optional<std::string> hessian_problem(Optimizer optimizer, SecondDerivatives hessian) {
  if (optimizer == Optimizer::gauss_newton && hessian == SecondDerivatives::limited_memory)
    return "limited-memory is for ipopt; for gauss-newton use gauss-newton or exact";
  if (optimizer != Optimizer::gauss_newton && optimizer != Optimizer::ipopt)
    return "belongs to the optimizer ipopt or gauss-newton; " + std::string(name_of(optimizer)) +
           " uses gradients only";
  return std::nullopt;
}

std::optional<std::string> hessian_problem(Method method, SecondDerivatives hessian) {
  if (method == Method::force_balance && hessian == SecondDerivatives::exact)
    return "exact second derivatives belong to the method dense-springs; for force-balance use "
           "gauss-newton or limited-memory";
  return std::nullopt;
}

std::optional<std::string> DesignSettings::problem() const {
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  if (!positive(max_error)) return "max_error must be a positive number";
  if (cables && *cables < 1) return "cables must be at least 1";
  if (threads && *threads < 1) return "threads must be at least 1";
  if (time && !positive(*time)) return "time must be a positive number of seconds";
  if (effort < 1 || effort > 3) return "effort must be 1, 2 or 3";
  if (!positive(spring_stiffness)) return "spring_stiffness must be a positive number";
  if (!positive(greedy_threshold)) return "greedy_threshold must be a positive number";
  if (sparsity_weights.empty() || !(sparsity_weights[0] >= 0) ||
      std::ranges::adjacent_find(sparsity_weights, std::greater_equal{}) != sparsity_weights.end())
    return "sparsity_weights: expected increasing numbers that are not negative";
  return std::nullopt;
}

}  // namespace tencer::model
