// Simplicial sparse L D L^T through CHOLMOD, without pivoting for stability: what a banded matrix
// with a few couplings wants.
#pragma once

#include <cholmod.h>

#include <mutex>
#include <tencer/linalg/symmetric_factor.hpp>

namespace tencer::linalg {

// One cholmod_common each, which is not copyable and holds the workspace of solves too: const
// functions take turns with it, so they may be called from several threads at once.
class SparseLdlt {
 public:
  SparseLdlt();
  ~SparseLdlt();
  SparseLdlt(const SparseLdlt&) = delete;
  SparseLdlt& operator=(const SparseLdlt&) = delete;

  // The ordering and the pattern of L. This, factorise and solve throw std::bad_alloc when there is
  // no memory for it.
  void analyse(const SymmetricMatrix& matrix);
  // Multiplications and additions a factorisation with the analysed pattern takes, and the entries
  // of L.
  double operations() const { return common_.fl; }
  double entries() const { return common_.lnz; }

  // matrix + shift * identity, with the analysed pattern. False when a pivot is lost in rounding.
  [[nodiscard]] bool factorise(const SymmetricMatrix& matrix, double shift);
  Inertia inertia() const;
  Eigen::MatrixXd solve(const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides) const;
  void solve(const Eigen::VectorXd& right_hand_side, Eigen::VectorXd& solution) const;
  Eigen::VectorXd negative_curvature() const;

 private:
  int size() const { return static_cast<int>(factor_->n); }
  double pivot(int j) const;
  bool pivots_are_significant() const;
  void require_memory() const;

  cholmod_factor* factor_ = nullptr;
  mutable std::mutex solving_;  // held by who uses what follows in a const function
  mutable cholmod_common common_{};
  mutable cholmod_dense* solution_ = nullptr;     // kept between solves
  mutable cholmod_dense* workspace_y_ = nullptr;  // the same
  mutable cholmod_dense* workspace_e_ = nullptr;
};

}  // namespace tencer::linalg
