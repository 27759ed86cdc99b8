// What every backend must do. Each adapter's tests call check_backend for each of its backends.
#pragma once

#include <stdexcept>
#include <tencer/optimize/backend.hpp>

#include "problems.hpp"

namespace tencer::optimize::test {

// Thrown by problems of check_exceptions.
struct Mishap : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// What must hold of any report, whatever the outcome.
void check_report(const Problem& problem, const Report& report);

void check_backend(const Backend& backend);

// Parts of it.
void check_answer(const Backend& backend, const Known& known, const Options& options);
void check_known_answers(const Backend& backend, Curvature curvature);
void check_lost_places(const Backend& backend);
void check_exceptions(const Backend& backend);
void check_limits(const Backend& backend);
void check_stop(const Backend& backend);
void check_callers_mistakes(const Backend& backend);

}  // namespace tencer::optimize::test
