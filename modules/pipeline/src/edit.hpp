// Designs made from other designs.
#pragma once

#include <optional>
#include <tencer/core/error.hpp>
#include <tencer/elimination/revise.hpp>
#include <tencer/model/scaling.hpp>
#include <tencer/model/scene.hpp>

namespace tencer::pipeline {

// What keeps a scene from being designed as its edit says; errors name the scene's source and the
// key.
std::optional<core::Error> check_edit(const model::Scene& scene);

// Of a scene with an edit: what the edit makes of the cables asked for and of the cables allowed.
void apply_edit(model::Scene& scene);

// The network that the edit goes on from, scaled, on the rods of the edited design; the cables that
// are kept come first, then those that go.
elimination::Revision revision_of(const model::Edit& edit, const model::Scaling& scaling);

}  // namespace tencer::pipeline
