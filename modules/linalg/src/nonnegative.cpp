#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tencer/core/error.hpp>
#include <tencer/linalg/nonnegative.hpp>

namespace tencer::linalg {
namespace {

// The variables that may be positive, with A restricted to them and its Cholesky factor, which
// grows by a row with each that enters.
class PositiveSet {
 public:
  const std::vector<int>& indices() const { return indices_; }
  Eigen::Index count() const { return static_cast<Eigen::Index>(indices_.size()); }

  // column: A(set, j), A(j, j). False when it depends on those in the set.
  bool add(int j, const Eigen::VectorXd& column) {
    constexpr double dependent = 1e-12;
    const Eigen::Index n = count();
    const Eigen::VectorXd row =
        factor_.topLeftCorner(n, n).triangularView<Eigen::Lower>().solve(column.head(n));
    const double rest = column[n] - row.squaredNorm();
    if (!(rest > dependent * column[n])) return false;
    if (n == matrix_.rows()) grow();
    matrix_.row(n).head(n) = column.head(n).transpose();
    matrix_.col(n).head(n) = column.head(n);
    matrix_(n, n) = column[n];
    factor_.row(n).head(n) = row.transpose();
    factor_(n, n) = std::sqrt(rest);
    indices_.push_back(j);
    return true;
  }

  void keep(const std::vector<Eigen::Index>& positions) {
    const Eigen::MatrixXd kept = matrix_(positions, positions);
    const auto n = static_cast<Eigen::Index>(positions.size());
    std::vector<int> indices;
    for (const auto position : positions) indices.push_back(indices_[position]);
    indices_ = std::move(indices);
    matrix_.topLeftCorner(n, n) = kept;
    factor_.topLeftCorner(n, n) = kept.llt().matrixL();
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    const auto lower = factor_.topLeftCorner(count(), count()).triangularView<Eigen::Lower>();
    return lower.transpose().solve(lower.solve(b));
  }
  Eigen::VectorXd times(const Eigen::VectorXd& z) const {
    return matrix_.topLeftCorner(count(), count()) * z;
  }

 private:
  void grow() {
    const Eigen::Index size = std::max<Eigen::Index>(16, 2 * matrix_.rows());
    matrix_.conservativeResize(size, size);
    factor_.conservativeResize(size, size);
  }

  std::vector<int> indices_;
  Eigen::MatrixXd matrix_, factor_;
};

}  // namespace

Nonnegative solve_nonnegative(const NonnegativeProblem& problem,
                              const NonnegativeOptions& options) {
  PositiveSet set;
  Eigen::VectorXd values;
  Eigen::VectorXd slope(problem.size);
  std::vector<bool> barred(problem.size, false);  // dependent on the present set
  Nonnegative result;
  const auto finished = [&](bool converged) {
    result.set = set.indices();
    result.values = values;
    result.converged = converged;
    return result;
  };
  problem.slope(set.indices(), values, slope);
  while (result.steps < options.max_steps) {
    std::vector<bool> inside = barred;
    for (const int j : set.indices()) inside[j] = true;
    int entering = -1;
    double steepest = options.tolerance;
    for (int j = 0; j < problem.size; ++j)
      if (!inside[j] && slope[j] > steepest) {
        steepest = slope[j];
        entering = j;
      }
    if (entering < 0) return finished(true);
    ++result.steps;
    if (!set.add(entering, problem.column(set.indices(), entering))) {
      barred[entering] = true;
      continue;
    }
    values.conservativeResize(set.count());
    values[set.count() - 1] = 0;
    // b on the set, the same at every point.
    Eigen::VectorXd b = set.times(values);
    for (Eigen::Index i = 0; i < set.count(); ++i) b[i] += slope[set.indices()[i]];
    for (;;) {
      const Eigen::VectorXd best = set.solve(b);
      // As far towards the unbounded solution as no variable turns negative.
      double way = 1;
      for (Eigen::Index i = 0; i < best.size(); ++i)
        if (best[i] <= 0) way = std::min(way, values[i] / (values[i] - best[i]));
      if (way == 1 && best.minCoeff() > 0) {
        values = best;
        break;
      }
      values += way * (best - values);
      const double zero = 1e-14 * values.maxCoeff();
      std::vector<Eigen::Index> positive;
      for (Eigen::Index i = 0; i < best.size(); ++i)
        if (values[i] > zero || best[i] > 0) positive.push_back(i);
      // The one that entered may be all rounding.
      if (static_cast<Eigen::Index>(positive.size()) == best.size()) positive.pop_back();
      values = Eigen::VectorXd(values(positive));
      b = Eigen::VectorXd(b(positive));
      set.keep(positive);
      if (positive.empty()) break;
    }
    if (std::ranges::find(set.indices(), entering) == set.indices().end()) {
      barred[entering] = true;
    } else {
      barred.assign(barred.size(), false);
    }
    if (problem.enough && problem.enough(set.indices(), values)) return finished(true);
    problem.slope(set.indices(), values, slope);
  }
  return finished(false);
}

Nonnegative solve_nonnegative(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                              const NonnegativeOptions& options) {
  core::require(A.rows() == A.cols() && A.rows() == b.size(),
                "solve_nonnegative: A must be square and fit b");
  NonnegativeProblem problem{.size = static_cast<int>(b.size())};
  problem.slope = [&](std::span<const int> set, const Eigen::VectorXd& values,
                      Eigen::VectorXd& slope) {
    slope = b;
    for (std::size_t i = 0; i < set.size(); ++i)
      slope -= values[static_cast<Eigen::Index>(i)] * A.col(set[i]);
  };
  problem.column = [&](std::span<const int> set, int j) {
    Eigen::VectorXd column(static_cast<Eigen::Index>(set.size()) + 1);
    for (std::size_t i = 0; i < set.size(); ++i)
      column[static_cast<Eigen::Index>(i)] = A(set[i], j);
    column[column.size() - 1] = A(j, j);
    return column;
  };
  return solve_nonnegative(problem, options);
}

}  // namespace tencer::linalg
