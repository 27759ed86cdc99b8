// The choice of an optimizer by name, from among those that are part of the build.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <tencer/core/error.hpp>
#include <tencer/optimize/options.hpp>
#include <tencer/optimize/problem.hpp>
#include <tencer/optimize/report.hpp>

namespace tencer::optimize {

struct Backend {
  std::string name;  // as in a scene file: "ipopt", "mma"
  std::string description;
  bool uses_hessian = false;
  // Throws std::invalid_argument for a wrong problem, start or options, and whatever the problem's
  // own functions throw; every numerical outcome is in the report.
  std::function<Report(const Problem&, const Eigen::VectorXd& start, const Options&)> minimise{};
};

// The backend called `name`, or an error (with no place) that names those that are there; a copy.
core::Expected<Backend> find_backend(std::span<const Backend> backends, std::string_view name);

}  // namespace tencer::optimize
