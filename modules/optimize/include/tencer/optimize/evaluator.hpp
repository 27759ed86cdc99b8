// What stands between a problem and a method that minimises it, the same for all methods: it
// counts, remembers the last point and the best, decides when to stop, and catches exceptions.
#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <tencer/optimize/options.hpp>
#include <tencer/optimize/problem.hpp>
#include <tencer/optimize/report.hpp>
#include <vector>

namespace tencer::optimize {

// For the writer of a backend: give the method value, gradient and hessian, tell accept when the
// method moves, return from the method as soon as finished() holds, and return finish(). None of
// these throws but the constructor and finish. `problem` and `options` must outlive the evaluator,
// which belongs to one thread.
class Evaluator {
 public:
  using Point = Eigen::Ref<const Eigen::VectorXd>;

  // Moves `start` (P) between the bounds and evaluates it. Throws std::invalid_argument when the
  // problem, the options or the start are wrong.
  Evaluator(const Problem& problem, const Eigen::VectorXd& start, const Options& options);

  const Eigen::VectorXd& start() const { return start_; }

  // A reason to stop is known; from now on nothing is evaluated.
  [[nodiscard]] bool finished() const { return reason_.has_value() || exception_ != nullptr; }

  // nullopt and false where p (P) cannot be evaluated or must not be (a limit, a stop, a step
  // beyond Options::initial_step).
  [[nodiscard]] std::optional<double> value(const Point& p);
  [[nodiscard]] bool gradient(const Point& p, Eigen::VectorXd& g);
  [[nodiscard]] bool hessian(const Point& p, Eigen::MatrixXd& h);

  // The method moved to p, whose gradient has been computed last. Repeating it changes nothing.
  void accept(const Point& p);

  // The method has returned, by itself or because finished() held. `breakdown`: what it says went
  // wrong, empty when it ended in good order. Rethrows what Problem's or Options' functions threw.
  Report finish(const std::string& breakdown = {});

 private:
  struct Evaluation {
    Eigen::VectorXd p;
    std::optional<double> value;
    std::optional<Eigen::VectorXd> gradient;
  };

  void guarded(const std::function<void()>& call);
  void evaluate(const Eigen::VectorXd& p);
  bool evaluate_gradient();
  bool may_evaluate(const Eigen::VectorXd& p);
  double slope(const Evaluation& at) const;
  double seconds() const;
  bool is_level() const;
  void describe(const std::string& breakdown);

  const Problem& problem_;
  const Options& options_;
  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  Eigen::VectorXd start_;
  Evaluation last_, best_;
  Eigen::VectorXd iterate_;  // accepted last
  double step_limit_;
  std::vector<double> accepted_values_;
  int tried_since_best_ = 0, failed_since_best_ = 0;
  std::optional<Reason> reason_;
  std::exception_ptr exception_;
  Report report_;
};

}  // namespace tencer::optimize
