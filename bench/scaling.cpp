// Cost as work grows: time and memory against size, with fitted exponents, beside the physical
// floor of the factorisations. Each size runs in a process of its own, so that its peak memory is
// its own. docs/scaling.md is made of the output. Usage: bench_scaling [SECONDS]: a design that
// takes longer is given up, and with it all larger ones of its study.
//
// To add a study, write a function from a size to a Sample and a line in `studies`.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <stdexcept>
#include <string_view>
#include <tencer/curves/analytic.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/design_state.hpp>
#include <vector>

#include "rates.hpp"

using namespace tencer;

namespace {

constexpr int max_columns = 9;

// What was measured at one size; columns in the order of the study's names.
struct Sample {
  std::array<double, max_columns> values{};
};

struct Study {
  const char* title;
  const char* size_name;
  std::vector<double> sizes;
  std::vector<const char*> columns;  // of Sample::values; the peak memory is added to them
  Sample (*measure)(int size);
  bool limited = false;  // by the time given on the command line
};

// Processor time of this process, all its threads together, or of this thread: what else the
// machine does hardly shows. (That of the process goes in ticks once there is a limit to it.)
double cpu_seconds(clockid_t of = CLOCK_PROCESS_CPUTIME_ID) {
  timespec now{};
  clock_gettime(of, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// One factorisation: what it took, and what it must take: its multiplications and additions at the
// best rate of a core, and its matrix read and its factor written at the rate of the cache or
// memory that holds them. These overlap at best.
struct Factorisation {
  double seconds = 0.0;
  double floor = 0.0;
  double operations = 0.0;
  double bytes = 0.0;  // of the factor
};

Factorisation factorisation(equilibrium::Linearisation& at) {
  Factorisation result{.seconds = 1e300};
  for (int k = 0; k < 9; ++k) {
    const double begin = cpu_seconds(CLOCK_THREAD_CPUTIME_ID);
    if (!at.factor.factorise(at.matrix)) throw std::runtime_error("not positive definite");
    result.seconds = std::min(result.seconds, cpu_seconds(CLOCK_THREAD_CPUTIME_ID) - begin);
  }
  const auto cost = at.factor.cost();
  result.operations = cost.operations;
  result.bytes = cost.bytes;
  const double moved =
      cost.bytes + static_cast<double>(at.matrix.nonZeros()) * (sizeof(double) + sizeof(int));
  result.floor = std::max(cost.operations / bench::flop_rate(),
                          moved / bench::read_rate(static_cast<std::size_t>(moved)));
  return result;
}

// A closed rod of n vertices on a circle, pressed to an oval by spokes to its neighbourhood's
// opposite: 24 cables whatever n is.
struct Model {
  model::Structure structure;
  Eigen::Matrix3Xd start;
};

Model ring_with_cables(int n) {
  der::Rod rod{.closed = true,
               .section = {.EA = 4e6, .EI1 = 1, .EI2 = 1, .GJ = 0.77},
               .rest_lengths = Eigen::VectorXd::Constant(n, 1.0 / n)};
  Model model{.structure = {.rods = {rod}}, .start = Eigen::Matrix3Xd::Zero(3, n)};
  for (int k = 0; k < 24; ++k)
    model.structure.cables.push_back({.a = springs::OnRod{0, k / 24.0},
                                      .b = springs::OnRod{0, k / 24.0 + 0.2 + 0.2 * (k % 3) / 2},
                                      .stiffness = 30,
                                      .rest_length = 0.05});
  for (int i = 0; i < n; ++i) {
    const double phi = 2 * std::numbers::pi * i / n;
    model.start.col(i) << std::cos(phi), std::sin(phi), 0.1 * std::sin(2 * phi);
  }
  model.start /= 2 * std::numbers::pi;
  return model;
}

Sample forward(int n) {
  const Model model = ring_with_cables(n);
  const double begin = cpu_seconds();
  const equilibrium::System system(model.structure);
  equilibrium::Linearisation at;
  const auto result =
      equilibrium::solve(system, make_state(model.structure, {model.start}), {}, at);
  const double whole = cpu_seconds() - begin;
  const Factorisation one = factorisation(at);
  return {{whole, one.floor * result.factorisations, static_cast<double>(result.iterations),
           static_cast<double>(result.factorisations), one.seconds, one.floor, one.operations,
           one.bytes, result.usable() ? 1.0 : 0.0}};
}

model::Scene scene_of(const std::vector<geometry::Polyline>& curves) {
  return model::scene_of(curves, "scaling");
}

// The floor is that of the factorisations in Newton's steps alone: how often gradients need a solve
// with the same factor, and what choosing cables needs, is a matter of the method.
Sample designed(const model::Scene& scene) {
  const double begin = cpu_seconds();
  const auto design = pipeline::design(scene);
  const double whole = cpu_seconds() - begin;
  if (!design) std::abort();
  const auto scaling = model::scaling_of(design->structure, design->target);
  const auto structure = model::scaled(design->structure, scaling);
  const equilibrium::System system(structure);
  equilibrium::Linearisation at;
  equilibrium::linearise(system, pipeline::pose_state(*design, structure, scaling), at);
  const Factorisation one = factorisation(at);
  double solves = 0, iterations = 0;
  for (const auto& row : design->trace) {
    solves += row.solves;
    iterations += row.iterations;
  }
  return {{whole, one.floor * iterations, solves, iterations, one.seconds, one.floor,
           static_cast<double>(design->built.size()), design->error->max_percent,
           design->status == model::DesignStatus::complete ? 1.0 : 0.0}};
}

Sample design_of_vertices(int n) {
  return designed(scene_of({curves::trefoil(curves::TrefoilForm::hypotrochoid, 198, n)}));
}

// A chain: bent ellipses of 50 vertices, each through the next and at right angles to it.
Sample design_of_rods(int rods) {
  std::vector<geometry::Polyline> chain;
  for (int r = 0; r < rods; ++r) {
    geometry::Polyline link = curves::ellipse(32.5, 25, 50);
    for (int i = 0; i < link.vertices(); ++i)
      link.points(2, i) = 5 * std::cos(4 * std::numbers::pi * i / link.vertices() + 0.1 * r);
    if (r % 2 == 1) link.points.row(1).swap(link.points.row(2));
    link.points.row(0).array() += 45.0 * r;
    chain.push_back(std::move(link));
  }
  return designed(scene_of(chain));
}

const std::vector<const char*> design_columns{"design cpu s", "floor s",     "solves",
                                              "steps",        "one fact. s", "its floor s",
                                              "cables",       "max error %", "complete"};

const std::vector<Study> studies{{"Forward solve: one closed rod of n vertices, 24 cables",
                                  "n",
                                  {1e2, 3e2, 1e3, 3e3, 1e4, 3e4, 1e5},
                                  {"solve cpu s", "floor s", "steps", "fact.", "one fact. s",
                                   "its floor s", "its flops", "bytes of L", "usable"},
                                  forward},
                                 {"Design: a trefoil of n vertices, within 1 %",
                                  "n",
                                  {50, 100, 200, 500, 1000, 2000, 2e4, 1e5},
                                  design_columns,
                                  design_of_vertices,
                                  true},
                                 {"Design: a chain of so many rods of 50 vertices, within 1 %",
                                  "rods",
                                  {1, 2, 5, 10, 20},
                                  design_columns,
                                  design_of_rods,
                                  true}};

// Measures in a child, which is ended after so many seconds of processor time; adds the peak of its
// resident memory in bytes. Empty when it did not end by itself.
std::vector<double> measured(const Study& study, int size, unsigned limit) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return {};
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    const rlimit most{limit, limit};
    if (study.limited) setrlimit(RLIMIT_CPU, &most);
    const Sample sample = study.measure(size);
    const bool sent = write(ends[1], &sample, sizeof sample) == sizeof sample;
    _exit(sent ? 0 : 1);
  }
  close(ends[1]);
  Sample sample;
  const bool received = read(ends[0], &sample, sizeof sample) == sizeof sample;
  close(ends[0]);
  rusage usage{};
  int status = 0;
  wait4(child, &status, 0, &usage);
  if (!received) return {};
  std::vector<double> values(sample.values.begin(), sample.values.begin() + study.columns.size());
  values.push_back(static_cast<double>(usage.ru_maxrss) * 1024);
  return values;
}

// The slope of log value over log size, by least squares over the larger half of the sizes, where
// fixed costs no longer count.
double exponent(const std::vector<double>& sizes, const std::vector<double>& values) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = (sizes.size() - 1) / 2; i < sizes.size(); ++i) {
    if (!(values[i] > 0)) continue;
    const double x = std::log(sizes[i]), y = std::log(values[i]);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

void print(const Study& study, unsigned limit) {
  std::printf("### %s\n\n| %s |", study.title, study.size_name);
  for (const char* column : study.columns) std::printf(" %s |", column);
  std::printf(" peak bytes |\n|---|");
  for (std::size_t c = 0; c <= study.columns.size(); ++c) std::printf("---|");
  std::printf("\n");
  std::vector<double> sizes;
  double given_up = 0;
  std::vector<std::vector<double>> columns(study.columns.size() + 1);
  for (const double size : study.sizes) {
    const auto values = measured(study, static_cast<int>(size), limit);
    if (values.empty()) {
      given_up = size;
      break;
    }
    std::printf("| %.0f |", size);
    for (const double value : values) std::printf(" %.3g |", value);
    std::printf("\n");
    sizes.push_back(size);
    for (std::size_t c = 0; c < columns.size(); ++c) columns[c].push_back(values[c]);
  }
  if (sizes.size() >= 3) {
    std::printf("| exponent |");
    for (const auto& column : columns) {
      const double slope = exponent(sizes, column);
      std::printf(std::isfinite(slope) ? " %.2f |" : " |", slope);
    }
    std::printf("\n");
  }
  if (given_up > 0)
    std::printf("\n%s = %g did not end within %u s of processor time.\n", study.size_name, given_up,
                limit);
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  unsigned limit = 600;
  if (argc > 1) {
    const std::string_view text = argv[1];
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), limit);
    if (error != std::errc() || end != text.data() + text.size() || limit == 0) {
      std::fprintf(stderr, "bench_scaling: expected whole seconds, not %s\n", argv[1]);
      return 2;
    }
  }
  std::printf("One core: %.3g flop/s, %.3g bytes/s from memory.\n\n", bench::flop_rate(),
              bench::read_rate(std::size_t{1} << 28));
  for (const Study& study : studies) print(study, limit);
}
