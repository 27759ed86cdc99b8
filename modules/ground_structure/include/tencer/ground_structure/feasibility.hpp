// Whether the candidates can hold the rods where the target is, with a proof when they cannot.
//
// First order. Forces balance at the target when A tau = f for tensions tau >= 0: f the forces of
// rods and loads, column c of A what candidate c's length gains as vertices move. By Farkas' lemma
// there are such tensions, or there is a motion v with A^T v <= 0, which lengthens no candidate,
// and f^T v > 0, along which the rods relax: then no tensions hold them there, however large. Both
// come out of one convex problem and its dual,
//
//   minimise v^T M v / 2 - f^T v over A^T v <= 0,
//   minimise (f - A tau)^T M^-1 (f - A tau) over tau >= 0,     v = M^-1 (f - A tau),
//
// M the rods' Hessian, made positive definite as in balanced_tensions.hpp: v is where the rods go,
// as far as this model tells, with all candidates tied at once.
//
// For good. Forces that balance may do so at a state that buckles. So the rods are let go with all
// candidates tied as they are long at the target. Where they come to rest elsewhere they got there
// on a way along which their energy fell and no candidate was lengthened: no choice of cables holds
// them at the target, since each choice leaves that way open.
#pragma once

#include <optional>
#include <stop_token>
#include <tencer/ground_structure/candidate_columns.hpp>
#include <tencer/ground_structure/problem.hpp>
#include <tencer/linalg/nonnegative.hpp>
#include <vector>

namespace tencer::ground_structure {

struct [[nodiscard]] Relaxation {
  linalg::Nonnegative tensions{};  // of the orbits
  Eigen::VectorXd motion{};        // v, of the free unknowns
  double power = 0.0;              // f^T v
  double lengthening = 0.0;        // the largest of A^T v: what rounding leaves of 0
  double largest = 0.0;            // displacement of a vertex
};

// The two solutions at `state`. none: the rods' Hessian is not finite there.
std::optional<Relaxation> relaxation(const equilibrium::System& bare, const model::State& state,
                                     const std::vector<CandidateOrbit>& orbits);

// Where the rods come to rest with the candidates tied: springs that pull at the target as the
// balance has it, a tenth as stiff as the rods are along themselves, or more where that stretches
// them.
struct [[nodiscard]] TiedRest {
  // A candidate that is longer by no more, relative to its length, counts as not lengthened: what
  // falls by that falls when a cable of a third of a metre is cut a millimetre too long.
  static constexpr double allowed_lengthening = 3e-3;

  model::State state{};
  bool rests = false;          // false: `state` is where it was given up
  double max_percent = 0.0;    // distance from the target, in % of its diagonal
  double released = 0.0;       // part of the rods' energy at the target that they lose on the way
  double lengthening = 0.0;    // the largest of all candidates, relative to their lengths
  std::vector<int> tied{};     // of the candidates: those that had to be tied
  Eigen::VectorXd tensions{};  // with which these pull, >= 0; most do not

  // Whether no candidate was lengthened on the way to a lower energy.
  bool proves_motion() const { return released > 0 && lengthening <= allowed_lengthening; }
};

struct TiedRestOptions {
  // Once the rods rest this near the target (in % of its diagonal) no further candidates are tied:
  // they would hold them all the better.
  double near_percent = 0.0;
  int max_iterations = 800;  // of Newton's method, in all
  std::stop_token stop{};

  // Throws std::invalid_argument, naming the field, when the numbers make no sense.
  void validate() const;
};

// From problem.start, moved a little so that it leaves a balance that is not stable; candidates and
// first: of problem.start, without symmetry. Candidates are tied only as they would be lengthened.
TiedRest tied_rest(const Problem& problem, const std::vector<CandidateOrbit>& candidates,
                   const Relaxation& first, const TiedRestOptions& options = {});

// Rods that lie apart from the others: every cable from them to the others, or to anchors, draws
// them there, and no cable can keep them away.
struct [[nodiscard]] Separation {
  std::vector<int> rods{};
  // A motion of the free unknowns, rigid for each rod, that shortens all these cables and lengthens
  // none of the others: the proof (Gordan's theorem).
  Eigen::VectorXd motion{};
};

// The first rods, or groups of them that can be tied among themselves, that no tensions can tie to
// the others, since these would not balance on them as a body; none: there are none. candidates: as
// above.
std::optional<Separation> separation(const Problem& problem,
                                     const std::vector<CandidateOrbit>& candidates);

}  // namespace tencer::ground_structure
