// Attachments that slide along the rods (paper section 5.3, "Spring Attachment Sliding").
#pragma once

#include <tencer/optimize/backend.hpp>
#include <tencer/sensitivity/target.hpp>
#include <tencer/sparsify/network.hpp>
#include <tencer/sparsify/outer.hpp>
#include <tencer/sparsify/rules.hpp>

namespace tencer::sparsify {

// Minimises the distance to the target over stiffnesses and attachments: closed rods wrap, open
// ones end; forbidden arcs and the longest cable are respected. T (eq. 7) of the result
// is never larger than that of `network`. Requires an equilibrium in which every cable pulls.
StageResult slide(const Network& network, const sensitivity::Target& target, const Rules& rules,
                  const optimize::Backend& backend, const OuterOptions& outer = {},
                  const Control& control = {});

}  // namespace tencer::sparsify
