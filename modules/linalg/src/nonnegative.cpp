#include <Eigen/Jacobi>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tencer/core/error.hpp>
#include <tencer/linalg/nonnegative.hpp>
#include <utility>

namespace tencer::linalg {
namespace {

using Eigen::Index;

void erase(Eigen::VectorXd& vector, Index position) {
  const Index after = vector.size() - position - 1;
  vector.segment(position, after) = vector.tail(after).eval();
  vector.conservativeResize(vector.size() - 1);
}

// The variables that may be positive, and the Cholesky factor of A restricted to them: a row more
// with each that enters, turned back into a triangle when one leaves.
struct PositiveSet {
  std::vector<int> indices{};
  Eigen::VectorXd values{};
  Eigen::MatrixXd lower{};  // with room for more rows

  Index count() const { return values.size(); }
  // The factor L, and L^T.
  auto factor() const {
    return lower.topLeftCorner(count(), count()).triangularView<Eigen::Lower>();
  }
  auto transposed() const {
    return lower.topLeftCorner(count(), count()).transpose().triangularView<Eigen::Upper>();
  }

  // row: of the factor.
  void add(int j, double value, const Eigen::VectorXd& row) {
    const Index n = count();
    if (n == lower.rows()) lower.conservativeResize(2 * n + 16, 2 * n + 16);
    lower.row(n).head(n + 1) = row.transpose();
    indices.push_back(j);
    values.conservativeResize(n + 1);
    values[n] = value;
  }

  void remove(Index position) {
    const Index n = count();
    for (Index i = position + 1; i < n; ++i) {
      lower.row(i - 1).head(i + 1) = lower.row(i).head(i + 1);
      Eigen::JacobiRotation<double> rotation;
      rotation.makeGivens(lower(i - 1, i - 1), lower(i - 1, i));
      auto rows = lower.block(i - 1, 0, n - i + 1, n);
      rows.applyOnTheRight(i - 1, i, rotation);
    }
    indices.erase(indices.begin() + position);
    erase(values, position);
  }
};

// How many times `step` may be gone until a value reaches zero, and which does so first; infinity
// when none decreases.
struct Reach {
  double times = std::numeric_limits<double>::infinity();
  Index first = -1;
};

Reach reach(const Eigen::VectorXd& values, const Eigen::VectorXd& step) {
  Reach result;
  for (Index i = 0; i < values.size(); ++i) {
    if (step[i] > 0 || (step[i] == 0 && values[i] > 0)) continue;
    const double times = values[i] > 0 ? values[i] / -step[i] : 0;
    if (times < result.times) result = {.times = times, .first = i};
  }
  return result;
}

// Takes j into the set, given its slope and A(set, j), A(j, j). Where A does not curve in the only
// direction that is new, the value falls all along it: one variable of the set goes to zero and
// leaves. False, with nothing changed, when none does.
bool enter(PositiveSet& set, int j, double slope, Eigen::VectorXd column) {
  constexpr double flat = 1e-12;
  double value = 0;
  const auto next_row = [&] {
    const Index n = set.count();
    Eigen::VectorXd row(n + 1);
    row.head(n) = set.factor().solve(column.head(n));
    row[n] = column[n] - row.head(n).squaredNorm();  // yet to be rooted
    return row;
  };
  Eigen::VectorXd row = next_row();
  const double min_curvature = flat * column[set.count()];
  if (!(row[set.count()] > min_curvature)) {
    const Eigen::VectorXd along = -set.transposed().solve(row.head(set.count()));
    const auto [times, first] = reach(set.values, along);
    if (first < 0 || times * row[set.count()] >= 2 * slope) return false;
    set.values = (set.values + times * along).cwiseMax(0);
    value = times;
    set.remove(first);
    erase(column, first);
    row = next_row();
  }
  row[set.count()] = std::sqrt(std::max(row[set.count()], min_curvature));
  set.add(j, value, row);
  return true;
}

// The minimum over the set from where it is, slope: b - A z there. Variables that reach zero on the
// way leave.
void minimise(PositiveSet& set, Eigen::VectorXd slope) {
  while (set.count() > 0) {
    const Eigen::VectorXd step = set.transposed().solve(set.factor().solve(slope));
    const auto [times, first] = reach(set.values, step);
    if (times > 1) {
      set.values += step;
      return;
    }
    set.values = (set.values + times * step).cwiseMax(0);
    slope *= 1 - times;
    set.remove(first);
    erase(slope, first);
  }
}

// The method: one variable enters at a time, and the minimum over the set is found anew.
class Search {
 public:
  Search(const NonnegativeProblem& problem, const NonnegativeOptions& options)
      : problem_(problem), options_(options), slope_(problem.size), barred_(problem.size, false) {}

  Nonnegative run() {
    const NonnegativeReason reason = descend();
    return {.set = std::move(set_.indices),
            .values = std::move(set_.values),
            .steps = steps_,
            .reason = reason};
  }

 private:
  NonnegativeReason descend() {
    if (!find_slope()) return NonnegativeReason::not_finite;
    for (;;) {
      const int entering = steepest();
      if (entering < 0) return endless_ ? NonnegativeReason::unbounded : NonnegativeReason::solved;
      if (steps_ == options_.max_steps) return NonnegativeReason::step_limit;
      ++steps_;
      const Eigen::VectorXd column = problem_.column(set_.indices, entering);
      core::require(column.size() == set_.count() + 1,
                    "NonnegativeProblem::column must give a number for each variable of the set, "
                    "and last A(j, j)");
      if (!column.allFinite()) return NonnegativeReason::not_finite;
      core::require(column[set_.count()] >= 0, "NonnegativeProblem::column: A(j, j) is negative");
      if (!take_in(entering, column)) continue;
      if (problem_.enough && problem_.enough(set_.indices, set_.values))
        return NonnegativeReason::enough;
      if (!find_slope()) return NonnegativeReason::not_finite;
    }
  }

  bool find_slope() {
    problem_.slope(set_.indices, set_.values, slope_);
    core::require(slope_.size() == problem_.size,
                  "NonnegativeProblem::slope must give a number for each variable");
    return slope_.allFinite();
  }

  int steepest() const {
    std::vector<bool> out = barred_;
    for (const int j : set_.indices) out[j] = true;
    int found = -1;
    for (int j = 0; j < problem_.size; ++j)
      if (!out[j] && slope_[j] > (found < 0 ? options_.tolerance : slope_[found])) found = j;
    return found;
  }

  // False when the variable could not enter, with the set as it was.
  bool take_in(int entering, const Eigen::VectorXd& column) {
    // Of the numbers a slope is the difference of; it is not known any better.
    constexpr double rounding = 1e-14;
    const double known_to =
        rounding * std::sqrt(column[set_.count()]) * (set_.transposed() * set_.values).norm();
    const bool negligible = slope_[entering] <= known_to;
    if (negligible || !enter(set_, entering, slope_[entering], column)) {
      barred_[entering] = true;
      endless_ = endless_ || !negligible;
      return false;
    }
    minimise(set_, slope_(set_.indices));
    if (std::ranges::find(set_.indices, entering) == set_.indices.end()) {
      barred_[entering] = true;  // its gain was all rounding
    } else {
      barred_.assign(barred_.size(), false);
      endless_ = false;
    }
    return true;
  }

  const NonnegativeProblem& problem_;
  const NonnegativeOptions& options_;
  PositiveSet set_{};
  Eigen::VectorXd slope_;
  std::vector<bool> barred_;  // until the set changes
  bool endless_ = false;      // nothing stops one of those barred
  int steps_ = 0;
};

}  // namespace

void NonnegativeOptions::validate() const {
  core::require(tolerance >= 0, "NonnegativeOptions: tolerance must not be negative");
  core::require(max_steps > 0, "NonnegativeOptions: max_steps must be positive");
}

Nonnegative solve_nonnegative(const NonnegativeProblem& problem,
                              const NonnegativeOptions& options) {
  core::require(problem.size >= 0 && problem.slope && problem.column,
                "NonnegativeProblem needs a size that is not negative, slope and column");
  options.validate();
  return Search(problem, options).run();
}

Nonnegative solve_nonnegative(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                              const NonnegativeOptions& options) {
  core::require(A.rows() == A.cols() && A.rows() == b.size(),
                "solve_nonnegative: A must be square and fit b");
  if (!A.allFinite() || !b.allFinite()) return {.reason = NonnegativeReason::not_finite};
  NonnegativeProblem problem{.size = static_cast<int>(b.size())};
  problem.slope = [&](std::span<const int> set, const Eigen::VectorXd& values,
                      Eigen::VectorXd& slope) {
    slope = b;
    for (std::size_t i = 0; i < set.size(); ++i)
      slope -= values[static_cast<Index>(i)] * A.col(set[i]);
  };
  problem.column = [&](std::span<const int> set, int j) {
    Eigen::VectorXd column(static_cast<Index>(set.size()) + 1);
    for (std::size_t i = 0; i < set.size(); ++i) column[static_cast<Index>(i)] = A(set[i], j);
    column[column.size() - 1] = A(j, j);
    return column;
  };
  return solve_nonnegative(problem, options);
}

}  // namespace tencer::linalg
