// How networks of fewer cables are searched for: what is asked, and the settings of each part of
// the search.
//
// The defaults were found on the published models (docs/results.md has the table, and what was
// tried without gain): each was varied by itself, and kept where it saved cables or time over all
// of them. Counts move by one or two either way with most of them.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <tencer/model/goal.hpp>
#include <tencer/model/settings.hpp>
#include <tencer/optimize/backend.hpp>

namespace tencer::elimination {

// Damped Gauss-Newton steps of a network's rest lengths and attachments.
struct StepOptions {
  // What a variable's change by an edge costs, in units of the objective. It adapts from `damping`
  // on within these limits.
  double damping = 1e-2;
  double min_damping = 3e-4;
  double max_damping = 1e3;
  double max_slide = 4.0;          // of an attachment in a step, in edges
  double kept_density = 0.2;       // part of a force density that a step leaves at least
  double tolerance = 1e-6;         // on the residual of equilibria on the way
  double max_turn = 1e-6;          // of an edge, which the residual leaves open there
  int max_iterations = 12;         // of Newton's method; good steps take 3 to 8
  double max_path_rotation = 0.3;  // radians; good steps seldom turn an edge by as much
  int attempts = 5;                // at a step, each half as far as the last

  // Throws std::invalid_argument, naming the field, unless the numbers make sense; so do all below.
  void validate() const;
};

// Backward elimination: one cable after another goes, the others refitted.
struct RemovalOptions {
  int tries = 2;          // different cables before a step of the elimination fails
  int batch_divisor = 6;  // 1 / this of the cables is taken out at once while there are many
  // Removals that end with at most this objective, or `growth` times that before, are taken without
  // a look at others; above it the rest is refitted, in at most `refits` steps.
  double good = 0.3;
  double growth = 1.5;
  int refits = 3;
  double jumped = 20;          // objective beyond which an equilibrium has jumped
  double unstable_cost = 1e3;  // of a cable without which the network is predicted to be unstable
  double min_part = 0.1;       // of a force density, in a gradual removal
  int gradual_steps = 8;       // of a gradual removal

  void validate() const;
};

// One way to descend. Which of them wins differs from target to target.
struct DescentSettings {
  double stability_weight = 0.5;  // see Objective in state/fitted_network.hpp
  // The objective's unit of distance is never smaller than this part of the error aimed at.
  double min_unit = 1.0;
  // The error aimed at on the way: this part of the one accepted, since what stays closer loses
  // fewer ways on; with a number of cables asked for, `times` the one that is wanted then.
  double part = 0.3;
  double times = 1.0;

  void validate() const;
};

using Portfolio = std::array<DescentSettings, 6>;
inline constexpr Portfolio standard_portfolio{{{0.5, 1.0, 0.3, 1.0},
                                               {5.0, 0.2, 0.3, 1.0},
                                               {0.5, 1.0, 1.0, 0.3},
                                               {0.5, 0.2, 0.3, 1.0},
                                               {0.05, 1.0, 0.3, 1.0},
                                               {0.05, 1.0, 1.0, 3.0}}};

// Iterated local search (Lourenco, Martin, Stutzle 2003): the best network loses and gains cables:
// such that bring it closer, or such that brace it while it does not stand.
struct LocalSearchOptions {
  int patience = 2;  // rounds without a better network before it ends
  int max_rounds = 12;
  int candidates = 40;         // insertions whose gain is worked out in full
  double alike = 0.1;          // of a rod's length: insertions with both ends this near are alike
  double brace_tension = 0.1;  // of the mean of the others'

  void validate() const;
};

// The last fit of a network, without a change of its cables' number.
struct FitOptions {
  // Who makes the last fit on the rods as they are. Not set: the search's own Gauss-Newton steps,
  // which make the fits on fewer vertices in any case.
  std::optional<optimize::Backend> optimizer{};
  // What an optimizer that uses them is given; there are no exact ones here.
  model::SecondDerivatives second_derivatives = model::SecondDerivatives::gauss_newton;
  int iterations = 40;          // of the optimizer in a round, with second derivatives
  int iterations_without = 80;  // and without
  double max_change = 4;        // of a variable in a round, in edges
  int rounds = 3;
  int steps = 6;           // in a round
  double min_gain = 0.03;  // of a step, below which a round ends
  double min_round_gain = 0.05;
  // Networks of an elimination with more cables than the fewest within the error that are fitted
  // while none stands.
  int further = 2;
  double power = 8;  // of the norm that stands for the largest distance
  // What does not stand may once it resists its softest motions more: these are tried one after the
  // other. The objective's unit of distance is never smaller than this part of the error accepted.
  struct Attempt {
    double stability_weight = 0.0;
    double min_unit = 0.0;
  };
  std::array<Attempt, 3> attempts{{{1e-2, 0.0}, {0.5, 0.5}, {3.0, 0.5}}};

  void validate() const;
};

// The networks that a search begins with.
struct StartOptions {
  // Forces are balanced to this part of the accepted error; the network is worth so many
  // eliminations.
  struct Balance {
    double part = 0.1;
    int descents = 6;
  };
  std::array<Balance, 2> balances{{{0.1, 6}, {0.5, 3}}};
  // The accepted error is taken to be between these, in %.
  double min_error_percent = 1e-2;
  double max_error_percent = 1.0;
  // Networks further away than this many accepted errors (max_error_percent at the least) are no
  // start: then springs are.
  double mendable = 1.5;
  int min_beam_cables = 6;  // networks of few candidates have at least up to so many cables
  // Some networks are given the symmetries that the target nearly has to begin with: groups of at
  // most so many operations (0: none), to this part of the diagonal of its box.
  int max_seed_order = 24;
  double nearly_symmetric = 1e-2;

  void validate() const;
};

// What is found on few vertices is brought back to all.
struct ProlongOptions {
  double fits_closer = 1.2;  // networks this much further than accepted are tried: fitting helps
  int spare = 2;  // further networks tried once one answers, twice as many while none stands

  void validate() const;
};

// The same problem on fewer vertices.
struct CoarseOptions {
  int min_edges = 48;
  double max_turn = 0.3;     // of a vertex, radians
  double worthwhile = 0.75;  // of the vertices: with more than so many left nothing is coarsened

  void validate() const;
};

// Many rods: cables are taken out of one block of rods at a time, the others held.
struct BlockOptions {
  int some_rods = 4;  // from so many on blocks are tried, as further starts
  int many_rods = 8;  // from so many on they are most of the search
  int max_sweeps = 6;
  int tried = 2;             // descents of a block, the thinnest first, put back into the whole
  double refit_above = 0.4;  // of the accepted error: then the whole is fitted again
  double soft_rest_ratio =
      0.9;  // of cables to the rods held: stiff ones would not let a block move

  void validate() const;
};

// What a network must forgive and keep so that it stands once it is built. Lengths are in scaled
// units (model/scaling.hpp).
struct Workmanship {
  double length_error = 0.0;      // of a cable's length, at most, either way
  double attachment_error = 0.0;  // of a mark's place on its rod, likewise
  double max_deviation = std::numeric_limits<double>::infinity();  // that these may cause (95 %)
  double min_tension_ratio = 0.0;  // the weakest cable's tension, of the strongest's
  double min_tension = 0.0;        // likewise, a force

  double least_tension(double largest) const {
    return std::max(min_tension_ratio * largest, min_tension);
  }

  void validate() const;
};

struct EliminationOptions {
  model::Goal goal{};
  model::Measure measure = model::Measure::max;  // what the last fit makes small
  // Softer networks are not entered (in the units of equilibrium::Stability): designs that fit ever
  // better by getting ever softer would not survive being built. A free straight rod has 500.
  // Networks that are softer at the start are held to a fifth of what they have.
  double min_eigenvalue = 500.0;
  Workmanship workmanship{};
  int threads = 2;  // the result does not depend on it
  StepOptions step{};
  RemovalOptions removal{};
  Portfolio portfolio = standard_portfolio;
  LocalSearchOptions local_search{};
  FitOptions fit{};
  StartOptions start{};
  CoarseOptions coarse{};
  ProlongOptions prolong{};
  BlockOptions block{};

  void validate() const;
};

}  // namespace tencer::elimination
