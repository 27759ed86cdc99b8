// From a scene to the problem that is solved: scaled units, a structure without cables, the target,
// and the rules for cables.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/core/scale.hpp>
#include <tencer/equilibrium/structure.hpp>
#include <tencer/io/design.hpp>
#include <tencer/io/scene.hpp>
#include <tencer/sensitivity/target.hpp>
#include <tencer/sparsify/rules.hpp>
#include <tencer/symmetry/group.hpp>
#include <vector>

namespace tencer::pipeline {

// Scaled coordinates are (scene coordinates - origin) / scale.length: the total rod length is 1 and
// the largest EI / length is 1, whatever the scene's units (numerics are relative).
struct Units {
  core::Scale scale{};
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();

  Eigen::Matrix3Xd scaled(const Eigen::Matrix3Xd& points) const {
    return (points.colwise() - origin) / scale.length;
  }
  Eigen::Matrix3Xd unscaled(const Eigen::Matrix3Xd& points) const {
    return (points * scale.length).colwise() + origin;
  }
};

// Something that only some scenes need, and whether this one does.
struct Part {
  std::string name{};  // "theta", "z", "registration", ...
  bool used = false;   // false: left out
  std::string why{};   // of either, half a sentence
};

struct Prepared {
  io::Design file{};                   // the design file but for cables, the pose the target
  equilibrium::Structure structure{};  // scaled, without cables
  sensitivity::Target target{};        // scaled
  sparsify::Rules rules{};             // scaled
  Units units{};
  // The rods at the target, where they start: with material frames that carry no moments which
  // cables would have to balance.
  equilibrium::State start{};
  // Of the rods, the target and what holds them; none when the scene does not ask for it, when the
  // method cannot keep it, or when there is none.
  std::optional<symmetry::Group> symmetry{};
  std::vector<Part> parts{};
};

// Errors name the scene's file or the curve a rod came from: a rod whose vertices meet, an anchor
// on a rod, loads that nothing holds, a symmetry that is not there.
core::Expected<Prepared> prepare(const io::Scene& scene);

}  // namespace tencer::pipeline
