#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <utility>

#include "forces.hpp"

namespace tencer::equilibrium {
namespace {

void check(const System& system, Linearisation& at, bool regular) {
  at.regular = regular;
  at.negative = regular ? at.factor.inertia().negative - system.saddle_unknowns() : 0;
}

bool same_pattern(const linalg::SymmetricMatrix& a, const linalg::SymmetricMatrix& b) {
  return a.cols() == b.cols() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

// Fills at.matrix with the Hessian, with these forces in its geometric part, and anchors it.
void fill(const System& system, const model::State& state, const InternalForces& forces,
          Linearisation& at) {
  if (!same_pattern(at.matrix, system.pattern())) at.matrix = system.pattern();
  system.hessian(state, forces, at.matrix);
  stabilise(system, at.rigid, at.matrix);
}

void add_diagonal(const Eigen::VectorXd& values, linalg::SymmetricMatrix& matrix) {
  for (Eigen::Index j = 0; j < values.size(); ++j)
    matrix.valuePtr()[matrix.outerIndexPtr()[j]] += values[j];  // first of the lower column
}

class Newton {
 public:
  Newton(const System& system, const SolveOptions& options, Linearisation& at, Equilibrium& result)
      : system_(system), options_(options), at_(at), result_(result) {}

  void run(model::State start);

 private:
  struct Point {
    model::State state;
    double energy = 0.0;
    double residual = std::numeric_limits<double>::infinity();  // also where the energy is infinite
    Eigen::VectorXd gradient{};
    InternalForces forces{};  // for the geometric stiffness: predicted by the step that led here
  };

  Point evaluate(model::State state);
  Point step_from(const Point& from, const Eigen::VectorXd& step);
  void factorise_positive(const Point& at);
  bool line_search(const Point& from, const Eigen::VectorXd& step, double slope, Point& result);
  void polish(Point& point);
  double curvature_along(const Eigen::VectorXd& motion) const {
    return motion.dot(at_.matrix.selfadjointView<Eigen::Lower>() * motion);
  }
  bool is_isolated();
  std::optional<Reason> conclude(const Point& point);
  bool escape(Point& point);
  void finish(Point&& point, Reason reason);
  bool balanced(const Point& point) const {
    return point.residual <= options_.tolerance ||
           is_rounding(system_, point.state, point.gradient);
  }

  static constexpr double near = 1e-3;  // turns of edges that every further step should halve
  static constexpr double quick = 0.1;  // a residual that fell by this is converging

  const System& system_;
  const SolveOptions& options_;
  Linearisation& at_;
  Equilibrium& result_;
  double shift_ = 0.0;
  double last_turn_ = std::numeric_limits<double>::infinity();
  double turned_ = 0.0;        // by edges, all steps together
  double turned_until_ = 0.0;  // how far they may before at_.rigid is found anew
};

Newton::Point Newton::evaluate(model::State state) {
  ++result_.evaluations;
  Point point{.state = std::move(state)};
  point.energy = system_.energy(point.state);
  if (!std::isfinite(point.energy)) return point;
  const ForceBalance balance = force_balance(system_, point.state);
  point.gradient = balance.gradient;
  point.residual = balance.residual;
  return point;
}

Newton::Point Newton::step_from(const Point& from, const Eigen::VectorXd& step) {
  Point point = evaluate(system_.displaced(from.state, step));
  point.forces = predicted_forces(system_, from.state, step);
  return point;
}

// Factorises the Hessian, made positive definite: first by leaving out compression, which is what
// makes it indefinite far from equilibrium, then by a shift in proportion to each rod's softest
// stiffness.
void Newton::factorise_positive(const Point& point) {
  constexpr double far = 0.5;  // residual above which predicted forces are not to be trusted
  // Any modes near those of this point anchor the matrix as well. One that nearly vanishes soon is
  // another; kept on, it would hold the rod where it is.
  constexpr double near_by = 0.2;
  if (turned_ >= turned_until_) {
    at_.rigid = rigid_modes(system_, point.state);
    turned_until_ = turned_ + near_by * steadiness(at_.rigid);
  }
  const auto attempt = [&] {
    check(system_, at_, at_.factor.factorise(at_.matrix));
    ++result_.factorisations;
    return at_.regular && at_.negative == 0;
  };
  fill(system_, point.state, point.forces, at_);
  if (shift_ == 0 && attempt()) return;
  if (point.residual > far) {
    InternalForces pulling = point.forces;
    for (auto& axial : pulling.axial) axial = axial.cwiseMax(0);
    pulling.tension = pulling.tension.cwiseMax(0);
    fill(system_, point.state, pulling, at_);
    if (shift_ == 0 && attempt()) return;
  }
  const Eigen::VectorXd softest = softest_stiffness(system_);
  constexpr double smallest = 0.1;
  double shift = std::max(shift_ / 30, smallest);
  for (double added = 0; std::isfinite(shift); added = shift, shift *= 10) {
    add_diagonal((shift - added) * softest, at_.matrix);
    if (attempt()) break;
  }
  shift_ = shift > smallest ? shift : 0;
}

// Takes further steps with the last factorisation, which cost a fraction of a new one, while each
// gains a digit.
void Newton::polish(Point& point) {
  Eigen::VectorXd step;
  while (!balanced(point)) {
    at_.factor.solve(-point.gradient, step);
    Point next = step_from(point, step);
    if (!(next.residual < quick * point.residual)) return;
    point = std::move(next);
  }
}

// Halves `step` from `from` until the energy falls enough.
bool Newton::line_search(const Point& from, const Eigen::VectorXd& step, double slope,
                         Point& result) {
  for (double length = 0.5; length > 1e-12; length /= 2) {
    Point trial = step_from(from, length * step);
    if (trial.energy <= from.energy + 1e-4 * length * slope) {
      result = std::move(trial);
      return true;
    }
  }
  return false;
}

// Whether the softest motion, or the one that at_ says lowers the energy, has a stiffness of which
// rounding leaves something.
bool Newton::is_isolated() {
  if (!at_.regular) return false;
  Eigen::VectorXd motion;
  if (at_.negative > 0) {
    motion = at_.factor.negative_curvature();
    // Rigid motion costs nothing, so what it seems to gain is rounding.
    Eigen::VectorXd deformation = motion;
    remove_rigid(at_.rigid, deformation);
    if (deformation.norm() <= 1e-6 * motion.norm()) return false;
    return curvature_along(motion) < -curvature_rounding(at_.matrix.diagonal(), motion);
  }
  // A generic force moves the structure mostly along its softest motion. Twisting moments, which
  // are no motions, get none.
  Eigen::VectorXd force(system_.size());
  for (int i = 0; i < force.size(); ++i) force[i] = std::sin(1.0 + i + 0.1 * i * i);
  force = (softest_stiffness(system_).array() > 0).select(force, 0);
  remove_rigid(at_.rigid, force);
  at_.factor.solve(force, motion);
  remove_rigid(at_.rigid, motion);
  return motion.isZero(0) || motion.dot(force) > curvature_rounding(at_.matrix.diagonal(), motion);
}

// At a state whose forces balance: why to end there; none when the Hessian is indefinite or the
// Newton step, with at_, still leads on. Balanced forces alone do not mean that the shape is right:
// rounding of forces along stiff edges may hide that little stiffness holds it elsewhere.
std::optional<Reason> Newton::conclude(const Point& point) {
  const double rough = std::max(1e-6, options_.max_turn);  // edges that turn by more: no answer
  linearise(system_, point.state, at_);
  ++result_.factorisations;
  result_.negative = at_.negative;
  if (!is_isolated()) return Reason::neutral;
  if (at_.negative > 0) return std::nullopt;
  Eigen::VectorXd step;
  at_.factor.solve(-point.gradient, step);
  const double turn = largest_rotation(system_, point.state, step);
  const bool halts = turn < near && turn > last_turn_ / 2;
  last_turn_ = turn;
  if (turn > options_.max_turn && !halts) return std::nullopt;
  if (turn > rough) return Reason::uncertain;
  return point.residual <= options_.tolerance ? Reason::converged : Reason::rounding;
}

// Leaves a saddle or maximum along a direction of negative curvature.
bool Newton::escape(Point& point) {
  Eigen::VectorXd direction = at_.factor.negative_curvature();
  double curvature = curvature_along(direction);
  remove_rigid(at_.rigid, direction);
  if (point.gradient.dot(direction) > 0) direction = -direction;
  const double scale = 0.1 / largest_rotation(system_, point.state, direction);
  direction *= scale;
  curvature *= scale * scale;
  const double rounding = energy_rounding(system_, point.state);
  for (double length = 1; length > 1e-12; length /= 2) {
    Point trial = evaluate(system_.displaced(point.state, length * direction));
    // Near the saddle the energy is lower by less than its rounding, while the force along the
    // direction still tells.
    if (!std::isfinite(trial.energy)) continue;
    if (trial.energy < point.energy - rounding ||
        trial.gradient.dot(direction) < curvature * length / 4) {
      point = std::move(trial);
      point.forces = system_.internal_forces(point.state);
      ++result_.escapes;
      return true;
    }
  }
  return false;
}

void Newton::finish(Point&& point, Reason reason) {
  result_.state = std::move(point.state);
  result_.energy = point.energy;
  result_.residual = point.residual;
  result_.reason = reason;
}

void Newton::run(model::State start) {
  Point now = evaluate(std::move(start));
  if (!std::isfinite(now.energy)) return finish(std::move(now), Reason::not_finite);
  if (system_.load_gradient().size() > 0 && !holds_loads(system_, rigid_modes(system_, now.state)))
    return finish(std::move(now), Reason::not_held);
  now.forces = options_.forces ? *options_.forces : system_.internal_forces(now.state);

  Point reference;  // the last point that lowered the energy, and the step tried from there
  Eigen::VectorXd reference_step;
  double reference_slope = 0;
  double rounding = 0;  // of its energy
  int waited = 0;
  for (;; ++result_.iterations) {
    const bool balance = balanced(now);
    if (balance) {
      if (const auto reason = conclude(now)) return finish(std::move(now), *reason);
      if (at_.negative > 0) {
        // Where rounding is all there is, escapes may lead from one saddle to the next for ever.
        if (options_.stop.stop_requested()) return finish(std::move(now), Reason::stopped);
        if (result_.iterations >= options_.max_iterations || !escape(now))
          return finish(std::move(now), Reason::saddle);
        waited = 0;
        continue;
      }
    }
    if (options_.stop.stop_requested()) return finish(std::move(now), Reason::stopped);
    if (result_.iterations >= options_.max_iterations)
      return finish(std::move(now), Reason::iteration_limit);

    if (!balance || last_turn_ > near) factorise_positive(now);
    Eigen::VectorXd step;
    at_.factor.solve(-now.gradient, step);
    const double slope = now.gradient.dot(step);
    const double turn = largest_rotation(system_, now.state, step);
    const double length = std::min(1.0, options_.max_rotation / turn);
    turned_ += length * turn;
    if (turned_ > options_.max_path_rotation) return finish(std::move(now), Reason::path_limit);
    step *= length;
    const double now_residual = now.residual;
    Point next = step_from(now, step);
    if (waited == 0) {
      reference = std::move(now);
      reference_step = std::move(step);
      reference_slope = slope;
      rounding = energy_rounding(system_, reference.state);
    }
    if (next.energy <= reference.energy + 1e-4 * reference_slope + rounding) {
      waited = 0;
      if (next.residual < quick * now_residual) polish(next);
      now = std::move(next);
    } else if (waited < options_.patience && std::isfinite(next.energy)) {
      ++waited;
      now = std::move(next);
    } else {
      waited = 0;
      if (!line_search(reference, reference_step, reference_slope, now))
        return finish(std::move(reference), Reason::no_descent);
    }
  }
}

bool fits(const InternalForces& forces, const model::Structure& structure) {
  return std::ranges::equal(forces.axial, structure.rods, {}, &Eigen::VectorXd::size,
                            &der::Rod::edges) &&
         forces.tension.size() == static_cast<Eigen::Index>(structure.cables.size());
}

}  // namespace

Eigen::MatrixXd Linearisation::solve(const Eigen::MatrixXd& b) const {
  Eigen::MatrixXd x = factor.solve(b);
  for (int k = 0; k < x.cols(); ++k) remove_rigid(rigid, x.col(k));
  return x;
}

void linearise(const System& system, const model::State& state, Linearisation& at) {
  linearise(system, state, system.internal_forces(state), at);
}

void linearise(const System& system, const model::State& state, const InternalForces& forces,
               Linearisation& at) {
  at.rigid = rigid_modes(system, state);
  fill(system, state, forces, at);
  check(system, at, at.factor.factorise(at.matrix));
}

Equilibrium solve(const System& system, model::State start, const SolveOptions& options,
                  Linearisation& workspace) {
  core::require(!options.forces || fits(*options.forces, system.structure()),
                "SolveOptions::forces: needs those of every edge and cable");
  Equilibrium result;
  Newton(system, options, workspace, result).run(std::move(start));
  return result;
}

Equilibrium solve(const System& system, model::State start, const SolveOptions& options) {
  Linearisation workspace;
  return solve(system, std::move(start), options, workspace);
}

std::string describe(Reason reason) {
  switch (reason) {
    case Reason::converged:
      return "converged to a stable equilibrium";
    case Reason::rounding:
      return "converged to a stable equilibrium, as far as rounding allows";
    case Reason::saddle:
      return "stopped at an unstable equilibrium";
    case Reason::neutral:
      return "stopped at an equilibrium that is not isolated: some motion costs nothing, or too "
             "little "
             "to tell from rounding";
    case Reason::uncertain:
      return "forces balance as far as rounding allows, but it leaves the shape uncertain";
    case Reason::iteration_limit:
      return "the iteration limit was reached";
    case Reason::path_limit:
      return "the way from the start became longer than was allowed";
    case Reason::no_descent:
      return "no step lowers the energy, although forces are not in balance";
    case Reason::not_held:
      return "there is no equilibrium: nothing holds the rods against their loads; pin them or tie "
             "them to anchors";
    case Reason::not_finite:
      return "the energy of the starting state is not finite (a folded rod or a zero-length edge)";
    case Reason::stopped:
      return "stopped on request";
  }
  return {};
}

double residual(const System& system, const model::State& state) {
  return force_balance(system, state).residual;
}

}  // namespace tencer::equilibrium
