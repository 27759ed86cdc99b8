#include "forward.hpp"

#include <cmath>
#include <numbers>
#include <tencer/registration/rigid.hpp>
#include <thread>
#include <utility>

namespace tencer::app::stress {
namespace {

// Asks a solve to stop after a minute, far beyond what any row takes.
class Deadline {
 public:
  Deadline()
      : timer_([this](const std::stop_token& over) {
          const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
          while (!over.stop_requested() && std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
          if (!over.stop_requested()) source_.request_stop();
        }) {}
  std::stop_token token() const { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::jthread timer_;
};

bool all_finite(const model::State& state) {
  for (const auto& rod : state)
    if (!rod.x.allFinite()) return false;
  return true;
}

std::string words(const equilibrium::Stability& stability) {
  if (!stability.computed) return "stability could not be computed";
  if (stability.negative > 0) return "unstable";
  if (stability.floating_components > 0)
    return std::to_string(stability.floating_components) + " groups of rods free of each other";
  return stability.stable() ? "stable" : "neutral";
}

Row row_of(const Forward& forward) {
  return {.name = forward.name, .known = forward.known, .promise = forward.promise};
}

void fill(Row& row, const Forward& forward, const equilibrium::Equilibrium& result,
          const equilibrium::Stability& stability) {
  row.iterations = result.iterations;
  row.residual = result.residual;
  row.ended = result.reason != equilibrium::Reason::stopped;
  row.finite = all_finite(result.state) && !std::isnan(result.residual) &&
               std::isfinite(stability.smallest_eigenvalue);
  row.claims_stable = result.usable() || stability.stable();
  row.claims_answer = result.usable() && stability.stable();
  if (result.usable() && forward.error && row.finite) row.error = forward.error(result.state);
  row.report = equilibrium::describe(result.reason);
  if (result.usable()) row.report += "; certificate: " + words(stability);
}

}  // namespace

der::Rod slender_rod(bool closed, Eigen::VectorXd rest_lengths, double slenderness,
                     double bending) {
  const double length = rest_lengths.sum();
  return {.closed = closed,
          .section = {.EA = 4 * bending * slenderness * slenderness / (length * length),
                      .EI1 = bending,
                      .EI2 = bending,
                      .GJ = bending / 1.3},
          .rest_lengths = std::move(rest_lengths)};
}

Eigen::VectorXd equal_lengths(int edges, double length) {
  return Eigen::VectorXd::Constant(edges, length / edges);
}

Eigen::Matrix3Xd polygon(int vertices, double circumference) {
  const double radius = circumference / vertices / (2 * std::sin(std::numbers::pi / vertices));
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, vertices);
  for (int i = 0; i < vertices; ++i) {
    const double phi = 2 * std::numbers::pi * i / vertices;
    x.col(i) << radius * std::cos(phi), radius * std::sin(phi), 0;
  }
  return x;
}

Error distance_from(Eigen::Matrix3Xd x, double size, int rod) {
  return [x = std::move(x), size, rod](const model::State& state) {
    const auto motion =
        registration::align(state[rod].x, x, Eigen::VectorXd::Ones(state[rod].x.cols()));
    return (motion.apply(state[rod].x) - x).colwise().norm().maxCoeff() / size;
  };
}

Row forward(const Forward& forward) {
  Row row = row_of(forward);
  const Deadline deadline;
  const equilibrium::System system(forward.structure);
  const auto result = equilibrium::solve(
      system, model::make_state(forward.structure, forward.start), {.stop = deadline.token()});
  fill(row, forward, result, equilibrium::stability(system, result.state));
  return row;
}

Row built(const Forward& forward) {
  Row row = row_of(forward);
  const Deadline deadline;
  const auto form = equilibrium::relax_inextensible(
      forward.structure, model::make_state(forward.structure, forward.start),
      {.stop = deadline.token()});
  const auto assessment =
      equilibrium::assess(forward.structure, form.equilibrium.state, form.tensions);
  fill(row, forward, form.equilibrium, assessment.stability);
  row.claims_answer = row.claims_answer && assessment.certified();
  if (!assessment.slack.empty()) row.report += "; slack cables";
  return row;
}

Eigen::Matrix3Xd arch(const der::Rod& rod, double span, double height) {
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, rod.vertices());
  const double length = rod.length();
  double s = 0;
  for (int i = 0; i < rod.vertices(); ++i) {
    const double t = i + 1 < rod.vertices() ? s / length : 1.0;
    x.col(i) << t * span, 4 * height * t * (1 - t), 0;
    if (i < rod.edges()) s += rod.rest_lengths[i];
  }
  return x;
}

Forward pinned_bow(std::string name, const der::Rod& rod, double angle, double promise) {
  const Bow answer = bow(rod, angle);
  model::Structure structure{
      .rods = {rod}, .pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = rod.vertices() - 1}}};
  return {.name = std::move(name),
          .structure = std::move(structure),
          .start = {arch(rod, answer.span, 0.7 * answer.x.row(1).maxCoeff())},
          .known = "shooting, 64-bit mantissa",
          .promise = promise,
          .error = distance_from(answer.x, rod.length())};
}

Forward strung_bow(std::string name, const der::Rod& rod, double angle, double promise) {
  Forward strung = pinned_bow(std::move(name), rod, angle, promise);
  strung.structure.pins.clear();
  strung.structure.cables = {{.a = springs::OnRod{0, 0},
                              .b = springs::OnRod{0, rod.length()},
                              .rest_length = bow(rod, angle).span}};
  return strung;
}

}  // namespace tencer::app::stress
