// Where a structure with inextensible cables goes when its cables' lengths change slowly: along the
// path of equilibria from a pose that is known, so that a jump is the structure's and never the
// solver's.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <tencer/equilibrium/inextensible.hpp>

namespace tencer::equilibrium {

struct PathOptions {
  // Largest step: turn of an edge in radians, or motion over the length of the longest rod.
  double max_step = 0.1;
  // How far beside the end of its tangent a step may come down, as a part of the tangent's length.
  double max_departure = 0.5;
  // The path has turned where it cannot be followed in steps as large as this part of the way.
  double min_step = 1e-4;
  bool beyond_fold = true;  // whether it is looked for where the structure goes from there
  // Of the relaxation from where the path turns; its tolerance and stop are those of the path too.
  SolveOptions solve{};

  // Throws std::invalid_argument, naming the field, unless all are positive and min_step <= 1.
  void validate() const;
};

struct [[nodiscard]] PathEquilibrium {
  InextensibleEquilibrium rest{};  // where it comes to rest at last, if that is looked for
  // Whether the start is stable with the forces that it lacks to balance, which fade along the way;
  // without that there is no path, and `rest` is relaxed from the start.
  bool held = false;
  // The part of the way, in [0, 1), after which the path turns or is no longer stable: there the
  // structure leaves it, and `rest` is relaxed from there.
  std::optional<double> fold_at = std::nullopt;
  int steps = 0;
  int rejected = 0;  // steps tried that were too long

  // Whether `rest` and the start are joined by stable equilibria.
  bool followed() const { return held && !fold_at && rest.equilibrium.usable(); }
};

// A pose that paths start from, with what is worked out once for all of them. May be used by
// several threads at once.
class PathStart {
 public:
  // tensions: one >= 0 a cable; without them, balancing_tensions() for the lengths at the pose. The
  // cables' rest_length does not count. Throws std::invalid_argument for a cable whose ends meet.
  PathStart(model::Structure structure, model::State state,
            const std::optional<Eigen::VectorXd>& tensions = std::nullopt);
  ~PathStart();
  PathStart(PathStart&&) noexcept;
  PathStart& operator=(PathStart&&) noexcept;

  // Of the cables at the pose, where the path starts.
  const Eigen::VectorXd& lengths() const;

 private:
  friend PathEquilibrium settle_along(const PathStart& start, const Eigen::VectorXd& lengths,
                                      const PathOptions& options);
  struct Implementation;
  std::unique_ptr<const Implementation> implementation_;
};

// Follows the path on which the cables' lengths go in proportion from those at the start to
// `lengths` (> 0, one a cable), while the forces that the start lacks to balance fade. Newton steps
// of the structure with taut cables as constraints; cables go slack and taut on the way. The step
// is the whole way first; a step is taken when it comes down near the end of its tangent at a
// stable pose.
PathEquilibrium settle_along(const PathStart& start, const Eigen::VectorXd& lengths,
                             const PathOptions& options = {});

// The same to the cables' rest_length.
PathEquilibrium settle_along(const model::Structure& structure, model::State start,
                             const std::optional<Eigen::VectorXd>& tensions = std::nullopt,
                             const PathOptions& options = {});

}  // namespace tencer::equilibrium
