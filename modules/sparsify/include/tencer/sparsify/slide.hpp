// Attachments that slide along the rods (paper section 5.3, "Spring Attachment Sliding").
#pragma once

#include <tencer/model/rules.hpp>
#include <tencer/model/target.hpp>
#include <tencer/network/stage.hpp>
#include <tencer/optimize/backend.hpp>
#include <tencer/sparsify/outer.hpp>

namespace tencer::sparsify {

// Minimises the distance to the target over stiffnesses and attachments: closed rods wrap, open
// ones end; forbidden arcs and the longest cable allowed are respected. T (eq. 7) of the result is
// never larger than that of `network`. A network that is not in equilibrium with every cable
// pulling comes back as it is, with its fault.
network::StageResult slide(const network::Network& network, const model::Target& target,
                           const model::Rules& rules, const optimize::Backend& backend,
                           const OuterOptions& outer = {}, const network::Control& control = {});

}  // namespace tencer::sparsify
