#include "taut_linearisation.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <tencer/equilibrium/constrained.hpp>
#include <utility>
#include <vector>

#include "forces.hpp"

namespace tencer::equilibrium {
namespace {

// Of a cable's compliance: what tells dependent cables apart.
constexpr double independent = 1e-12;

// What stands for a taut cable: as stiff as the stiffest edge.
double spring_stiffness(const model::Structure& structure) {
  double stiffness = 0;
  for (const auto& rod : structure.rods)
    stiffness = std::max(stiffness, rod.section.EA / rod.length() * rod.edges());
  return stiffness;
}

}  // namespace

bool TautLinearisation::linearise(System& system, const model::State& state,
                                  const InternalForces& forces) {
  const double stiffness = spring_stiffness(system.structure());
  springs_ = (forces.tension.array() > 0)
                 .select(Eigen::VectorXd::Constant(forces.tension.size(), stiffness), 0);
  return factorise(system, state, forces) && at_.negative == 0;
}

bool TautLinearisation::linearise(System& system, const model::State& state,
                                  const InternalForces& forces, const std::vector<bool>& taut) {
  const double stiffness = spring_stiffness(system.structure());
  springs_.resize(static_cast<Eigen::Index>(taut.size()));
  std::vector<Eigen::Index> held;
  for (std::size_t c = 0; c < taut.size(); ++c) {
    springs_[static_cast<Eigen::Index>(c)] = taut[c] ? stiffness : 0;
    if (taut[c]) held.push_back(static_cast<Eigen::Index>(c));
  }
  if (!factorise(system, state, forces)) return false;
  // As in ConstrainedHessian: a negative eigenvalue of the compliance is one that the springs hide.
  negative_ = at_.negative;
  if (held.empty()) return true;
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
                                     compliance_(held, held), Eigen::EigenvaluesOnly)
                                     .eigenvalues();
  negative_ -=
      static_cast<int>((values.array() < -independent * values.cwiseAbs().maxCoeff()).count());
  return true;
}

bool TautLinearisation::factorise(System& system, const model::State& state,
                                  const InternalForces& forces) {
  std::vector<springs::Cable> cables = system.structure().cables;
  for (std::size_t c = 0; c < cables.size(); ++c)
    cables[c].stiffness = springs_[static_cast<Eigen::Index>(c)];
  system.set_cables(std::move(cables));
  equilibrium::linearise(system, state, forces, at_);
  if (!at_.regular) return false;
  border_rigid_motion(system);
  pulls_ = length_gradients(system, state);
  motions_ = pulls_.cols() > 0 ? solve(pulls_) : pulls_;
  compliance_ = pulls_.transpose() * motions_;
  return compliance_.allFinite();
}

HeldStep TautLinearisation::step(const Eigen::VectorXd& gradient, const Eigen::VectorXd& tensions,
                                 const Eigen::VectorXd& gap, const Eigen::VectorXd& growth,
                                 const WayEquation& equation) const {
  const Eigen::VectorXd free_motion = -solve(gradient).col(0);
  const Eigen::VectorXd free_growth = pulls_.transpose() * free_motion;
  std::vector<Eigen::Index> held;
  for (Eigen::Index c = 0; c < springs_.size(); ++c)
    if (springs_[c] > 0) held.push_back(c);
  const auto size = static_cast<Eigen::Index>(held.size());
  // Of the forces `pull` besides tensions and springs, and the part: motion = free_motion -
  // motions_ * pull, of which held cables get longer by gap + part * growth.
  Eigen::MatrixXd matrix(size + 1, size + 1);
  matrix.topLeftCorner(size, size) = compliance_(held, held);
  matrix.topLeftCorner(size, size).diagonal().array() +=
      size > 0 ? independent * compliance_.diagonal().maxCoeff() : 0;
  matrix.topRightCorner(size, 1) = growth(held);
  matrix.bottomLeftCorner(1, size) =
      -(equation.along.transpose() * motions_(Eigen::all, held)).eval();
  matrix(size, size) = equation.rate;
  Eigen::VectorXd right(size + 1);
  right << (free_growth - gap)(held), equation.ahead - equation.along.dot(free_motion);
  const Eigen::VectorXd solution = matrix.fullPivLu().solve(right);
  HeldStep result{.motion = free_motion,
                  .tensions = Eigen::VectorXd::Zero(tensions.size()),
                  .part = solution[size],
                  .solved = solution.allFinite()};
  if (size > 0) result.motion -= motions_(Eigen::all, held) * solution.head(size);
  const Eigen::VectorXd longer = pulls_.transpose() * result.motion;
  for (Eigen::Index i = 0; i < size; ++i) {
    const Eigen::Index c = held[static_cast<std::size_t>(i)];
    result.tensions[c] = tensions[c] + solution[i] + springs_[c] * longer[c];
  }
  return result;
}

void TautLinearisation::border_rigid_motion(const System& system) {
  Eigen::Index count = 0;
  for (const auto& rigid : at_.rigid) count += rigid.basis.cols();
  border_ = Eigen::MatrixXd::Zero(system.size(), 2 * count);
  if (count == 0) return;
  const Eigen::VectorXd root = edge_stiffness(system).cwiseSqrt();
  Eigen::Index first = 0;
  for (std::size_t g = 0; g < at_.rigid.size(); ++g) {
    const auto& basis = at_.rigid[g].basis;
    if (basis.cols() == 0) continue;
    const auto& unknowns = system.stabilising_unknowns()[g];
    border_(unknowns, Eigen::seqN(first, basis.cols())) =
        root(unknowns).asDiagonal() * at_.rigid[g].stabilising;
    border_.middleCols(count + first, basis.cols()) = basis;
    first += basis.cols();
  }
  border_motions_ = at_.factor.solve(border_);
  border_motions_.rightCols(count) *= -1;
  Eigen::MatrixXd matrix = border_.transpose() * border_motions_;
  matrix.topLeftCorner(count, count).diagonal().array() -= 1;
  border_matrix_.compute(matrix);
}

// dx and the rigid part of the forces, l, of H dx + B l = forces, B^T dx = 0, H + S S^T at hand: B
// the basis and S the anchors, S^T dx one more unknown.
Eigen::MatrixXd TautLinearisation::solve(const Eigen::MatrixXd& forces) const {
  Eigen::MatrixXd motion = at_.factor.solve(forces);
  if (border_.cols() > 0)
    motion -= border_motions_ * border_matrix_.solve(border_.transpose() * motion);
  return motion;
}

TautStep TautLinearisation::step(const Eigen::VectorXd& gradient, const Eigen::VectorXd& tensions,
                                 const Eigen::VectorXd& gap) const {
  const Eigen::Index count = tensions.size();
  const Eigen::VectorXd free_motion = -solve(gradient).col(0);
  const Eigen::VectorXd free_growth = pulls_.transpose() * free_motion;
  const double regular = count > 0 ? independent * compliance_.diagonal().maxCoeff() : 0;
  TautStep result{.tensions = tensions};
  // The spring forces `pull` besides the tensions: the motion is free_motion - motions_ * pull, and
  // the new tension of a cable tensions + pull + springs_ * growth.
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(count);
  std::vector<bool> taut(static_cast<std::size_t>(count));
  for (Eigen::Index c = 0; c < count; ++c) taut[static_cast<std::size_t>(c)] = tensions[c] > 0;
  const int together = 8;  // rounds in which all cables change that are on the wrong side
  for (int round = 0; round < together + 2 * count + 1 && !result.solved; ++round) {
    std::vector<Eigen::Index> unknown;
    for (Eigen::Index c = 0; c < count; ++c)
      if (taut[static_cast<std::size_t>(c)] || springs_[c] > 0) unknown.push_back(c);
    const auto size = static_cast<Eigen::Index>(unknown.size());
    Eigen::MatrixXd matrix(size, size);
    Eigen::VectorXd right(size);
    for (Eigen::Index i = 0; i < size; ++i) {
      const Eigen::Index c = unknown[static_cast<std::size_t>(i)];
      const bool is_taut = taut[static_cast<std::size_t>(c)];
      for (Eigen::Index j = 0; j < size; ++j) {
        const double yields = compliance_(c, unknown[static_cast<std::size_t>(j)]);
        matrix(i, j) = is_taut ? yields : -springs_[c] * yields;
      }
      matrix(i, i) += is_taut ? regular : 1;
      right[i] = is_taut ? free_growth[c] - gap[c] : -tensions[c] - springs_[c] * free_growth[c];
    }
    const Eigen::VectorXd solution =
        size > 0 ? Eigen::VectorXd(matrix.partialPivLu().solve(right)) : right;
    if (!solution.allFinite()) return result;
    pull.setZero();
    for (Eigen::Index i = 0; i < size; ++i)
      pull[unknown[static_cast<std::size_t>(i)]] = solution[i];
    const Eigen::VectorXd growth = free_growth - compliance_ * pull;
    result.tensions = tensions + pull + springs_.cwiseProduct(growth);
    result.solved = true;
    for (Eigen::Index c = 0; c < count; ++c) {
      const auto k = static_cast<std::size_t>(c);
      const bool wrong = taut[k] ? result.tensions[c] < 0
                                 : growth[c] > gap[c] + 1e-12 * std::abs(free_growth[c]) + 1e-15;
      if (!taut[k]) result.tensions[c] = 0;
      if (!wrong) continue;
      result.solved = false;
      taut[k] = !taut[k];
      if (round >= together) break;  // one after the other ends where all together may cycle
    }
  }
  result.tensions = result.tensions.cwiseMax(0);
  result.motion = free_motion - motions_ * pull;
  return result;
}

}  // namespace tencer::equilibrium
