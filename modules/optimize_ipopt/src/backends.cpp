#include <IpIpoptApplication.hpp>
#include <IpTNLP.hpp>
#include <algorithm>
#include <mutex>
#include <tencer/optimize/evaluator.hpp>
#include <tencer/optimize_ipopt/backends.hpp>

namespace tencer::optimize_ipopt {
namespace {

using Ipopt::Index;
using Ipopt::Number;
using optimize::Evaluator;
using optimize::Options;
using optimize::Problem;
using optimize::Report;

using ConstMap = Eigen::Map<const Eigen::VectorXd>;
using Map = Eigen::Map<Eigen::VectorXd>;

// The bounds are simple bounds and there are no constraints.
class BoundedProblem final : public Ipopt::TNLP {
 public:
  BoundedProblem(const Problem& problem, Evaluator& evaluator)
      : problem_(problem), evaluator_(evaluator) {}

  bool get_nlp_info(Index& n, Index& m, Index& nonzeros_jacobian, Index& nonzeros_hessian,
                    IndexStyleEnum& index_style) override {
    n = static_cast<Index>(problem_.size());
    m = 0;
    nonzeros_jacobian = 0;
    nonzeros_hessian = n * (n + 1) / 2;
    index_style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* lower, Number* upper, Index, Number*, Number*) override {
    // Beyond 1e19 Ipopt takes a bound for infinite.
    Map(lower, n) = problem_.lower.cwiseMax(-2e19);
    Map(upper, n) = problem_.upper.cwiseMin(2e19);
    return true;
  }

  bool get_starting_point(Index n, bool, Number* x, bool, Number*, Number*, Index, bool,
                          Number*) override {
    Map(x, n) = evaluator_.start();
    return true;
  }

  // False, not a huge number, where there is no value: a huge number was once accepted as the
  // optimum. The line search then shortens its step.
  bool eval_f(Index n, const Number* x, bool, Number& value) override {
    const auto known = evaluator_.value(ConstMap(x, n));
    if (known) value = *known;
    return known.has_value();
  }

  // Asked for at accepted iterates only.
  bool eval_grad_f(Index n, const Number* x, bool, Number* gradient) override {
    const ConstMap p(x, n);
    Eigen::VectorXd g;
    if (!evaluator_.gradient(p, g)) return false;
    Map(gradient, n) = g;
    evaluator_.accept(p);
    return true;
  }

  bool eval_g(Index, const Number*, bool, Index, Number*) override { return true; }
  bool eval_jac_g(Index, const Number*, bool, Index, Index, Index*, Index*, Number*) override {
    return true;
  }

  bool eval_h(Index n, const Number* x, bool, Number factor, Index, const Number*, bool, Index,
              Index* rows, Index* columns, Number* values) override {
    Eigen::MatrixXd h;
    if (values != nullptr && !evaluator_.hessian(ConstMap(x, n), h)) return false;
    for (Index column = 0, entry = 0; column < n; ++column)
      for (Index row = column; row < n; ++row, ++entry) {
        if (values != nullptr) {
          values[entry] = factor * h(row, column);
        } else {
          rows[entry] = row;
          columns[entry] = column;
        }
      }
    return true;
  }

  bool intermediate_callback(Ipopt::AlgorithmMode, Index, Number, Number, Number, Number, Number,
                             Number, Number, Number, Index, const Ipopt::IpoptData*,
                             Ipopt::IpoptCalculatedQuantities*) override {
    return !evaluator_.finished();
  }

  void finalize_solution(Ipopt::SolverReturn, Index, const Number*, const Number*, const Number*,
                         Index, const Number*, const Number*, Number, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {}

 private:
  const Problem& problem_;
  Evaluator& evaluator_;
};

void set_options(Ipopt::OptionsList& list, const Options& options) {
  list.SetIntegerValue("print_level", 0);
  list.SetStringValue("sb", "yes");  // no banner
  // The problem comes scaled; Ipopt's own scaling would depend on the start.
  list.SetStringValue("nlp_scaling_method", "none");
  list.SetStringValue("hessian_approximation", options.curvature == optimize::Curvature::supplied
                                                   ? "exact"
                                                   : "limited-memory");
  // The evaluations cost more than the algebra.
  list.SetIntegerValue("limited_memory_max_history", 50);
  // The evaluator judges convergence; Ipopt's own test, of a scaled quantity, only comes later.
  list.SetNumericValue("tol", std::max(1e-3 * options.gradient_tolerance, 1e-14));
  list.SetIntegerValue("acceptable_iter", 0);
  list.SetIntegerValue("max_iter", options.max_iterations);
  // By default the bounds are relaxed by 1e-8, and the result may violate them.
  list.SetNumericValue("bound_relax_factor", 0.0);
  // By default the start is pushed 1e-2 off its bounds, which a warm start does not survive; the
  // barrier has to start as low, or it pushes in its turn.
  const double push = std::min(1e-4, 0.5 * options.initial_step);
  list.SetNumericValue("bound_push", push);
  list.SetNumericValue("bound_frac", push);
  list.SetNumericValue("mu_init", 1e-4);
  // Places without a value are dear, so steps shorten faster than by the default halves; 0.1, which
  // is faster still, took up to five times as many evaluations along curved valleys.
  list.SetNumericValue("alpha_red_factor", 0.25);
  // The watchdog tries steps that do not lower the value, at the price of evaluations.
  list.SetIntegerValue("watchdog_shortened_iter_trigger", 0);
}

// Empty for an end in good order, of which the evaluator knows the reason.
std::string breakdown(Ipopt::ApplicationReturnStatus status) {
  switch (status) {
    case Ipopt::Invalid_Problem_Definition:
      return "Ipopt: invalid problem definition";
    case Ipopt::Invalid_Option:
      return "Ipopt: invalid option";
    case Ipopt::Error_In_Step_Computation:
      return "Ipopt: no step could be computed";
    case Ipopt::Unrecoverable_Exception:
      return "Ipopt: unrecoverable exception";
    case Ipopt::NonIpopt_Exception_Thrown:
      return "Ipopt: an exception of another library";
    case Ipopt::Insufficient_Memory:
      return "Ipopt: not enough memory";
    case Ipopt::Internal_Error:
      return "Ipopt: internal error";
    default:
      return {};
  }
}

// MUMPS, Ipopt's linear solver here, is not thread-safe: two runs at a time crash.
std::mutex& mumps() {
  static std::mutex mutex;
  return mutex;
}

Report minimise(const Problem& problem, const Eigen::VectorXd& start, const Options& options) {
  Evaluator evaluator(problem, start, options);
  if (evaluator.finished()) return evaluator.finish();
  std::string trouble;
  {
    const std::scoped_lock lock(mumps());
    Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
    set_options(*application->Options(), options);
    // Without the empty name it would read ipopt.opt from the working directory.
    auto status = application->Initialize("");
    if (status == Ipopt::Solve_Succeeded)
      status = application->OptimizeTNLP(new BoundedProblem(problem, evaluator));
    trouble = breakdown(status);
  }
  return evaluator.finish(trouble);
}

}  // namespace

std::vector<optimize::Backend> backends() {
  return {{.name = "ipopt",
           .description = "interior point (Ipopt), limited-memory or supplied Hessian",
           .uses_hessian = true,
           .minimise = minimise}};
}

}  // namespace tencer::optimize_ipopt
