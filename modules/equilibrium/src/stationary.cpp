#include <algorithm>
#include <limits>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/stationary.hpp>
#include <tencer/equilibrium/system.hpp>
#include <utility>

#include "forces.hpp"
#include "pulling_cables.hpp"
#include "taut_linearisation.hpp"

namespace tencer::equilibrium {
namespace {

class Search {
 public:
  Search(const model::Structure& structure, const model::State& state, const InternalForces& forces,
         double reach)
      : system_(structure), state_(state), reach_(reach), forces_(forces) {
    const Eigen::VectorXd& tensions = forces.tension;
    lengths_.resize(tensions.size());
    for (Eigen::Index c = 0; c < tensions.size(); ++c)
      lengths_[c] = structure.cables[static_cast<std::size_t>(c)].rest_length;
    for (const double tension : tensions) taut_.push_back(tension > 0);
    for (const auto& rod : structure.rods) longest_ = std::max(longest_, rod.length());
  }

  std::optional<Stationary> run() {
    constexpr int most_changes = 10;
    for (int k = 0; k < most_changes; ++k) {
      if (!balance()) return std::nullopt;
      if (!change_taut())
        return Stationary{std::move(state_), forces_.tension.cwiseMax(0), at_.negative()};
    }
    return std::nullopt;
  }

 private:
  // With the cables that are taut now.
  bool balance() {
    constexpr int most = 20;
    constexpr double near = 1e-9;
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(lengths_.size());
    const WayEquation stay{Eigen::VectorXd::Zero(system_.size()), 1, 0};
    for (int k = 0; k < most; ++k) {
      if (!at_.linearise(system_, state_, forces_, taut_)) return false;
      // Further steps with the same factor, while each is much shorter than the last.
      for (double last = std::numeric_limits<double>::infinity();;) {
        const HeldStep next =
            at_.step(gradient_with(system_, state_, forces_.tension), forces_.tension,
                     lengths_ - cable_lengths(system_, state_), none, stay);
        if (!next.solved) return false;
        const double size = std::max(largest_rotation(system_, state_, next.motion),
                                     largest_motion(system_, next.motion) / longest_);
        // Rounding of long, stiff rods' forces may leave steps of more than the tolerance.
        const bool rounding = size <= 1e2 * near && size > last / 2;
        if (!(size < last / 10) && !rounding) break;
        reach_ -= size;
        if (!(reach_ >= 0)) return false;
        forces_ = predicted_forces(system_, state_, next.motion);
        system_.displace(state_, next.motion);
        forces_.tension = next.tensions;
        if (size <= near || rounding) return true;
        last = size;
      }
    }
    return false;
  }

  // Lets cables that push go slack and those that are too long pull. False: there are none.
  bool change_taut() {
    constexpr double negligible = 1e-7;
    bool changed = false;
    const Eigen::VectorXd lengths = cable_lengths(system_, state_);
    for (Eigen::Index c = 0; c < lengths_.size(); ++c) {
      auto&& taut = taut_[static_cast<std::size_t>(c)];
      const bool wrong =
          taut ? forces_.tension[c] < 0 : lengths[c] > lengths_[c] * (1 + negligible);
      if (!wrong) continue;
      taut = !taut;
      forces_.tension[c] = 0;
      changed = true;
    }
    return changed;
  }

  System system_;
  model::State state_;
  double reach_;
  InternalForces forces_;
  Eigen::VectorXd lengths_{};
  std::vector<bool> taut_{};
  double longest_ = 0.0;
  TautLinearisation at_{};
};

}  // namespace

std::optional<Stationary> stationary_near(const model::Structure& structure,
                                          const model::State& state, const InternalForces& forces,
                                          double reach) {
  const Eigen::VectorXd& tensions = forces.tension;
  core::require(tensions.size() == static_cast<Eigen::Index>(structure.cables.size()) &&
                    (tensions.size() == 0 || tensions.minCoeff() >= 0),
                "stationary_near: needs one tension >= 0 per cable");
  return Search(structure, state, forces, reach).run();
}

}  // namespace tencer::equilibrium
