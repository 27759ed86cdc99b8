// Follows an equilibrium while the cables change, as the inner loop of a design problem (paper
// section 5.3): predict with the last factorisation, correct with Newton, notice jumps.
#pragma once

#include <stop_token>
#include <string>
#include <tencer/equilibrium/solve.hpp>
#include <vector>

namespace tencer::sensitivity {

// An equilibrium with its factorised Hessian, which is what derivatives need.
struct Configuration {
  equilibrium::System system;
  model::State state{};
  equilibrium::Linearisation linearisation{};

  const std::vector<springs::Cable>& cables() const { return system.structure().cables; }
};

struct TrackerOptions {
  double tolerance = 1e-10;  // on the equilibrium's residual; 100 times below the outer one
  int max_iterations = 100;  // steps of Newton's method
  // An equilibrium further from the prediction than this times the predicted motion counts as a
  // jump (largest motions of a vertex, rigid motions left out), unless it is within `negligible`
  // times the structure's size.
  double max_correction = 0.5;
  double negligible = 1e-4;
  // A change of the cables that makes the equilibrium jump is followed in smaller and smaller parts
  // before it counts as failed, down to this one (1: never divided).
  double smallest_step = 0.125;
  geometry::Side side = geometry::Side::after;
  std::stop_token stop{};
};

enum class Outcome {
  followed,      // a stable equilibrium on the branch of the committed one
  jumped,        // a stable equilibrium far from the prediction
  lost_balance,  // Newton met an unstable equilibrium and left it: the branch has ended or turned
  not_solved     // no stable equilibrium found; see Trial::equilibrium.reason
};
std::string describe(Outcome outcome);

// How an evaluation went; where it took several parts, how the last one did.
struct Trial {
  Outcome outcome = Outcome::not_solved;
  equilibrium::Equilibrium equilibrium{};  // Newton's report; its state is Configuration::state
  bool predicted = false;                  // whether Newton started from the prediction
  double motion = 0.0;                     // largest predicted motion of a vertex, length
  double correction = 0.0;  // largest distance of a vertex from its predicted position, length
  int solves = 0;           // of an equilibrium

  bool usable() const { return outcome == Outcome::followed; }
};

// A trial depends on the committed configuration and the cables alone, to the last bit, not on what
// was evaluated in between. Which branch is committed does depend on the way there; equilibria that
// are followed in small enough steps stay on the branch of the first.
class Tracker {
 public:
  // Solves for the structure's equilibrium from `start`, which becomes the committed configuration
  // when first().usable(). Throws std::invalid_argument for an unusable structure.
  Tracker(model::Structure structure, model::State start, TrackerOptions options = {});

  const equilibrium::Equilibrium& first() const { return first_; }
  const Configuration& committed() const { return committed_; }

  // The equilibrium with these cables: the committed ones, each with its ends on the same rods and
  // anchors, at other places and with other stiffness and rest length. Requires a usable committed
  // configuration. trial() holds the configuration until the next call.
  Trial evaluate(const std::vector<springs::Cable>& cables);
  const Configuration& trial() const { return trial_; }

  // Makes the last trial the committed configuration; requires that it was usable.
  void commit();

 private:
  Trial step(const Configuration& from, std::vector<springs::Cable> cables);

  TrackerOptions options_;
  equilibrium::Equilibrium first_;
  Configuration committed_, trial_, halfway_;
  bool trial_usable_ = false;
};

}  // namespace tencer::sensitivity
