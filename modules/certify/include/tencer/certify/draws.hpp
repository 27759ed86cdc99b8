// Structures built with errors of their cables and let settle: what tolerance.hpp tells to first
// order, without its limits.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <tencer/certify/tolerance.hpp>

namespace tencer::certify {

// One structure built with errors.
struct Draw {
  // Largest distance of a vertex from the pose, aligned as there, where it comes to rest with its
  // errors, or when it falls.
  double deviation = 0.0;
  bool rests = true;  // false: it was not found where it comes to rest
  // Its path could be followed, from the pose or to where it turns; false: it was relaxed at once.
  bool followed = true;
  // The part of the way from no errors to these at which the path of its poses turns, so that it
  // falls to another pose; not set: it follows them all the way.
  std::optional<double> falls_at = std::nullopt;

  bool keeps_its_path() const { return rests && followed && !falls_at; }
};

// The draws of unit_draws with these errors, each along its path from the pose (equilibrium/
// path.hpp). Fewer when stopped. Errors that leave a cable no length leave it a millionth of it.
// views: as pose_response has them.
std::vector<Draw> settle_draws(const model::Structure& structure, const model::State& state,
                               const Eigen::VectorXd& tensions, const CableErrors& errors,
                               int draws, std::uint64_t seed, const std::stop_token& stop = {},
                               const std::vector<model::View>& views = {});

// Whether all of them would keep their paths; ends with the first that does not. false when
// stopped.
bool all_keep_their_paths(const model::Structure& structure, const model::State& state,
                          const Eigen::VectorXd& tensions, const CableErrors& errors, int draws,
                          std::uint64_t seed, const std::stop_token& stop = {});

// By how many times the errors the first of some draws falls.
struct FirstFall {
  std::optional<double> times{};  // not set: none does, as far as was looked
  double looked_to = 0.0;         // so many times; 0: not all could be followed at once the errors
};

// Looked for by doubling the errors from one to `most` times, while all can be followed. once: what
// settle_draws found with these errors and this seed.
FirstFall first_fall(const model::Structure& structure, const model::State& state,
                     const Eigen::VectorXd& tensions, const CableErrors& errors,
                     const std::vector<Draw>& once, std::uint64_t seed, double most,
                     const std::stop_token& stop = {});

}  // namespace tencer::certify
