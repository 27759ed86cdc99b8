// The outer optimizers with functions of Python's as the objective.
#include <tencer/optimize/backend.hpp>
#include <tencer/pipeline/backends.hpp>

#include "arrays.hpp"
#include "parts.hpp"

namespace tencer::python {
namespace {

using namespace py::literals;
using optimize::Report;

const char* name_of(optimize::Reason reason) {
  using enum optimize::Reason;
  switch (reason) {
    case converged:
      return "converged";
    case small_progress:
      return "small progress";
    case evaluation_limit:
      return "evaluation limit";
    case iteration_limit:
      return "iteration limit";
    case stopped:
      return "stopped";
    case lost:
      return "lost";
    case failed:
      break;
  }
  return "failed";
}

// Calls Python; Ctrl-C in there asks to stop and counts as no answer, other exceptions go through.
class Caller {
 public:
  py::object operator()(const py::object& function, const Eigen::VectorXd& p) {
    try {
      return function(owned(p));
    } catch (py::error_already_set& error) {
      if (!error.matches(PyExc_KeyboardInterrupt)) throw;
      stop_.request_stop();
      return py::none();
    }
  }
  std::stop_token token() const { return stop_.get_token(); }

 private:
  std::stop_source stop_;
};

// What a function returned, as a vector of `size`.
bool take(const py::object& answer, Eigen::Index size, Eigen::VectorXd& g) {
  if (answer.is_none()) return false;
  const Given array = answer.cast<Given>();
  g = numbers_of(array, "gradient");
  if (g.size() != size)
    throw std::invalid_argument("gradient: expected " + std::to_string(size) + " numbers, found " +
                                std::to_string(g.size()));
  return true;
}

bool take(const py::object& answer, Eigen::Index size, Eigen::MatrixXd& h) {
  if (answer.is_none()) return false;
  const Given array = answer.cast<Given>();
  if (array.ndim() != 2 || array.shape(0) != size || array.shape(1) != size)
    throw std::invalid_argument("hessian: expected an array of shape (" + std::to_string(size) +
                                ", " + std::to_string(size) + ")");
  h = Eigen::Map<const Eigen::MatrixXd>(array.data(), size, size);  // symmetric
  return true;
}

Report minimise(const py::object& value, const Given& start, const py::object& gradient,
                const py::object& hessian, const std::optional<Given>& lower,
                const std::optional<Given>& upper, const std::string& method, int max_evaluations,
                int max_iterations, double gradient_tolerance, double value_tolerance,
                double initial_step, const py::object& progress) {
  const auto backend = optimize::find_backend(pipeline::backends(), method);
  if (!backend) throw std::invalid_argument("method: " + backend.error().message);
  const Eigen::VectorXd from = numbers_of(start, "start");
  const double inf = std::numeric_limits<double>::infinity();
  Caller call;
  optimize::Problem problem{
      .lower = Eigen::VectorXd::Constant(from.size(), -inf),
      .upper = Eigen::VectorXd::Constant(from.size(), inf),
      .value = [&](const Eigen::VectorXd& p) -> std::optional<double> {
        const py::object answer = call(value, p);
        return answer.is_none() ? std::nullopt : std::optional(answer.cast<double>());
      },
      .gradient = [&](const Eigen::VectorXd& p,
                      Eigen::VectorXd& g) { return take(call(gradient, p), from.size(), g); },
      .hessian = {}};
  if (lower) problem.lower = numbers_of(*lower, "lower");
  if (upper) problem.upper = numbers_of(*upper, "upper");
  if (!hessian.is_none())
    problem.hessian = [&](const Eigen::VectorXd& p, Eigen::MatrixXd& h) {
      return take(call(hessian, p), from.size(), h);
    };
  optimize::Options options{.max_evaluations = max_evaluations,
                            .max_iterations = max_iterations,
                            .gradient_tolerance = gradient_tolerance,
                            .value_tolerance = value_tolerance,
                            .initial_step = initial_step,
                            .curvature = hessian.is_none() ? optimize::Curvature::limited_memory
                                                           : optimize::Curvature::supplied,
                            .stop = call.token()};
  if (!progress.is_none())
    options.progress = [&](const optimize::Progress& at) { call(progress, at.point); };
  return backend->minimise(problem, from, options);
}

}  // namespace

void bind_optimize(py::module_& module) {
  py::class_<Report>(module, "Minimum", "What came of a minimisation.")
      .def_property_readonly("point",
                             [](py::object self) { return view(self.cast<Report&>().point, self); })
      .def_readonly("value", &Report::value)
      .def_readonly("usable", &Report::usable, "The point has a value, the lowest that was found.")
      .def_property_readonly("reason", [](const Report& self) { return name_of(self.reason); })
      .def_readonly("message", &Report::message)
      .def_readonly("projected_gradient", &Report::projected_gradient)
      .def_readonly("iterations", &Report::iterations)
      .def_readonly("evaluations", &Report::evaluations)
      .def("__repr__", [](const Report& self) { return "<Minimum: " + self.message + ">"; });
  module.def(
      "minimise", &minimise, "value"_a, "start"_a, "gradient"_a, "hessian"_a = py::none(),
      "lower"_a = py::none(), "upper"_a = py::none(), "method"_a = "ipopt",
      "max_evaluations"_a = 2000, "max_iterations"_a = 1000, "gradient_tolerance"_a = 1e-6,
      "value_tolerance"_a = 1e-10, "initial_step"_a = std::numeric_limits<double>::infinity(),
      "progress"_a = py::none(),
      "The least value of a smooth function between bounds.\n\n"
      "value(p) -> float, or None where there is none; gradient(p) -> (parameters,) and hessian(p) "
      "-> "
      "(parameters, parameters) are asked at the p that had its value last. start, lower, upper: "
      "(parameters,). method: one of optimizers(); gauss-newton needs a hessian. progress(p): "
      "after "
      "each iterate. Ctrl-C ends it with the best so far.");
  module.def(
      "optimizers",
      [] {
        std::vector<std::string> names;
        for (const optimize::Backend& backend : pipeline::backends()) names.push_back(backend.name);
        return names;
      },
      "The names of the optimizers of this build.");
}

}  // namespace tencer::python
