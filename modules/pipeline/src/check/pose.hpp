// A design at rest, as the sections of a check look at it.
#pragma once

#include <tencer/model/check.hpp>
#include <tencer/model/design.hpp>
#include <tencer/model/material.hpp>
#include <tencer/model/scaling.hpp>
#include <tencer/model/state.hpp>
#include <tencer/model/target.hpp>
#include <tencer/pipeline/check.hpp>

namespace tencer::pipeline {

struct RestPose {
  const model::Design& design;  // at rest, in its units
  model::Scaling scaling;
  // Scaled: the structure with its cables as built, where it is, and one tension a cable.
  model::Structure structure;
  model::State state;
  Eigen::VectorXd tensions;
};

RestPose rest_pose(const model::Design& design);

// What rod r is made of: glass fibre where the design does not say it.
inline const model::Material& material_of(const model::Design& design, std::size_t r) {
  const auto& materials = design.structure.materials;
  return materials.empty() ? model::glass_fibre() : materials[r];
}

// Per rod, of the scaled structure: kg/m in its force times second^2 per length^2.
Eigen::VectorXd mass_per_length(const RestPose& pose);

// How many of the design's lengths a millimetre is.
double millimetre_of(const model::Design& design);

// The target's bounding-box diagonal, a length.
double size_of(const model::Design& design);

// moved: how far the design came from the pose it was given in, a length.
model::Stands stands(const RestPose& pose, double moved);

// Not set where the pose has no first order.
std::optional<model::Forgives> forgives_linearly(const RestPose& pose, const CheckOptions& options);

// The same, and how some of the draws settle, which takes most of a check's time.
std::optional<model::Forgives> forgives(const RestPose& pose, const CheckOptions& options);

// How they settle only where that decides: what falls short to first order does so.
std::optional<model::Forgives> forgives_enough(const RestPose& pose, const CheckOptions& options);

// Not set where the modes to push along are not known.
std::optional<model::ComesBack> comes_back(const RestPose& pose, const CheckOptions& options);

model::Holds holds(const RestPose& pose, const CheckOptions& options);

model::OwnWeight own_weight(const RestPose& pose, const CheckOptions& options);

model::Clear clear(const RestPose& pose);

// Not set when it was stopped before the first.
std::optional<model::Converged> converged(const model::Design& design, const CheckOptions& options);

}  // namespace tencer::pipeline
