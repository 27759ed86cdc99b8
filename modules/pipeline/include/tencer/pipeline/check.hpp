// Whether a design can be built and does then what it should.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <tencer/core/error.hpp>
#include <tencer/model/build.hpp>
#include <tencer/model/check.hpp>
#include <tencer/model/design.hpp>

namespace tencer::pipeline {

// Lengths in mm, whatever the design's unit.
struct CheckOptions {
  double length_error_mm = model::usual_length_error_mm;  // of a cable's length, at most
  // Of where a cable is tied along a rod, at most.
  double attachment_error_mm = model::usual_attachment_error_mm;
  model::Allowance max_deviation{};  // what 95 % of the structures built so may be off by
  // Of a cable: a 1 mm wire rope (7 x 7) of stainless steel, by a typical table.
  double breaking_load_newtons = 560;
  int draws = 10000;  // of errors, to first order
  // Errors are doubled, until a draw falls, up to so many times.
  double most_times = 8;
  std::uint64_t seed = 1;
  bool repair = false;  // ties what moves at no cost with the fewest cables, and checks that
  std::stop_token stop{};

  // Throws std::invalid_argument, naming the field, for values out of range.
  void validate() const;
};

struct [[nodiscard]] Checked {
  // As it comes to rest from its pose with inextensible cables, with those of a repair.
  model::Design design{};
  model::Check check{};  // of that; where it does not come to rest, `stands` alone
};

// Of a design at rest in its pose, what a search has to answer for: forgives, clear and converged;
// and what weight does to it. Structures with errors are let settle only where that decides: what
// falls short to first order does so.
model::Check quick_check(const model::Design& design, const CheckOptions& options);

// What errors do to that design, with some structures let settle in any case, which takes most of a
// check's time. Not set where the pose has no first order.
std::optional<model::Forgives> forgiven_errors(const model::Design& design,
                                               const CheckOptions& options);

// Errors: as simulate().
core::Expected<Checked> check(const model::Design& design, const CheckOptions& options = {});

}  // namespace tencer::pipeline
