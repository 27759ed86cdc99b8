#include <cmath>
#include <tencer/equilibrium/rigid_modes.hpp>
#include <tencer/ground_structure/feasibility.hpp>
#include <utility>

namespace tencer::ground_structure {
namespace {

// What tensions of the cables between bodies do to the bodies, and which of these cables a body
// has.
class Bodies {
 public:
  // Bodies are what the structure's cables tie together.
  Bodies(const model::Structure& structure, const model::State& state,
         const std::vector<CandidateOrbit>& candidates)
      : system_(structure), modes_(equilibrium::rigid_modes(system_, state)) {
    for (const CandidateOrbit& orbit : candidates)
      if (body_of(orbit.front().cable.a) != body_of(orbit.front().cable.b))
        joining_.push_back(&orbit.front());
    Eigen::Index rows = 0;
    for (const auto& component : modes_) rows += component.basis.cols();
    wrenches_ = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(joining_.size()));
    for (std::size_t c = 0; c < joining_.size(); ++c)
      add_wrench(*joining_[c], wrenches_.col(static_cast<Eigen::Index>(c)));
  }

  int count() const { return static_cast<int>(modes_.size()); }
  // A body that some rigid motion is left to; -1: there is none.
  int first_free() const {
    for (int body = 0; body < count(); ++body)
      if (modes_[body].basis.cols() > 0) return body;
    return -1;
  }

  std::vector<int> rods(int body) const {
    std::vector<int> result;
    const auto& component = system_.component_of_rod();
    for (std::size_t r = 0; r < component.size(); ++r)
      if (component[r] == body) result.push_back(static_cast<int>(r));
    return result;
  }

  // Tensions tau >= 0 of the cables between bodies, one of them on this body, that balance on all
  // bodies; or the motion that proves that there are none. With B their wrenches and s = 1 for the
  // cables of this body, tau that minimise |B tau|^2 + (s tau - 1)^2 leave a motion -B tau along
  // which each cable lengthens by at most -s (1 - s tau).
  struct Answer {
    std::vector<springs::Cable> pulling{};
    Eigen::VectorXd motion{};  // empty: there are such tensions
  };
  Answer balance_on(int body) const {
    constexpr double balanced = 1e-6;
    Eigen::MatrixXd columns(wrenches_.rows() + 1, wrenches_.cols());
    columns.topRows(wrenches_.rows()) = wrenches_;
    for (std::size_t c = 0; c < joining_.size(); ++c) {
      const springs::Cable& cable = joining_[c]->cable;
      columns(wrenches_.rows(), static_cast<Eigen::Index>(c)) =
          body_of(cable.a) == body || body_of(cable.b) == body ? 1 : 0;
    }
    const auto tensions = linalg::solve_nonnegative(least_squares(columns), {.tolerance = 1e-12});
    Eigen::VectorXd rest = Eigen::VectorXd::Unit(columns.rows(), columns.rows() - 1);
    rest -= columns(Eigen::all, tensions.set) * tensions.values;
    Answer answer;
    if (tensions.converged() && rest[rest.size() - 1] > balanced) {
      answer.motion = motion_of(rest.head(wrenches_.rows()));
      return answer;
    }
    for (std::size_t i = 0; i < tensions.set.size(); ++i)
      if (tensions.values[static_cast<Eigen::Index>(i)] > 0)
        answer.pulling.push_back(joining_[tensions.set[i]]->cable);
    return answer;
  }

 private:
  // -1: space.
  int body_of(const springs::End& end) const {
    const auto* on = std::get_if<springs::OnRod>(&end);
    return on ? system_.component_of_rod()[on->rod] : -1;
  }

  void add_wrench(const CandidateColumn& column, Eigen::Ref<Eigen::VectorXd> wrench) const {
    // Of the size of the tension, whatever the number of vertices.
    const double scale = std::sqrt(system_.size());
    Eigen::Index row = 0;
    for (const auto& component : modes_) {
      auto part = wrench.segment(row, component.basis.cols());
      if (part.size() > 0)
        for_each_unknown(system_, column, [&](int i, double weight) {
          part += scale * weight * component.basis.row(i).transpose();
        });
      row += component.basis.cols();
    }
  }

  // Of so much of each body's rigid motions.
  Eigen::VectorXd motion_of(const Eigen::VectorXd& parts) const {
    Eigen::VectorXd motion = Eigen::VectorXd::Zero(system_.size());
    Eigen::Index row = 0;
    for (const auto& component : modes_) {
      motion += component.basis * parts.segment(row, component.basis.cols());
      row += component.basis.cols();
    }
    return motion;
  }

  // Towards the unit vector of the last row.
  static linalg::NonnegativeProblem least_squares(const Eigen::MatrixXd& columns) {
    linalg::NonnegativeProblem problem{.size = static_cast<int>(columns.cols())};
    problem.slope = [&columns](std::span<const int> set, const Eigen::VectorXd& values,
                               Eigen::VectorXd& slope) {
      Eigen::VectorXd rest = Eigen::VectorXd::Unit(columns.rows(), columns.rows() - 1);
      for (std::size_t i = 0; i < set.size(); ++i)
        rest -= values[static_cast<Eigen::Index>(i)] * columns.col(set[i]);
      slope = columns.transpose() * rest;
    };
    problem.column = [&columns](std::span<const int> set, int j) {
      Eigen::VectorXd products(static_cast<Eigen::Index>(set.size()) + 1);
      for (std::size_t i = 0; i < set.size(); ++i)
        products[static_cast<Eigen::Index>(i)] = columns.col(set[i]).dot(columns.col(j));
      products[products.size() - 1] = columns.col(j).squaredNorm();
      return products;
    };
    return problem;
  }

  equilibrium::System system_;
  std::vector<equilibrium::RigidModes> modes_;
  std::vector<const CandidateColumn*> joining_{};  // different bodies, or a body and an anchor
  Eigen::MatrixXd wrenches_;  // on the bodies' free rigid motions, a column for each of these
};

}  // namespace

std::optional<Separation> separation(const Problem& problem,
                                     const std::vector<CandidateOrbit>& candidates) {
  // What loads do to a body has to be balanced as well.
  if (!problem.structure.point_loads.empty() || !problem.structure.line_loads.empty()) return {};
  model::Structure structure = problem.structure;
  // With the cables that can tie a body it is one with those that they join it to.
  for (std::size_t k = 0; k < problem.structure.rods.size(); ++k) {
    const Bodies bodies(structure, problem.start, candidates);
    const int body = bodies.count() < 2 ? -1 : bodies.first_free();
    if (body < 0) return {};
    auto answer = bodies.balance_on(body);
    if (answer.motion.size() > 0)
      return Separation{.rods = bodies.rods(body), .motion = std::move(answer.motion)};
    for (springs::Cable& cable : answer.pulling) structure.cables.push_back(cable);
  }
  return {};
}

}  // namespace tencer::ground_structure
