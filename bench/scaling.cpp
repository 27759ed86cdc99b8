// Cost as work grows: time and memory against size, with fitted exponents, beside the physical
// floor of the factorisation. Each size runs in a process of its own, so that its peak memory is
// its own. Usage: bench_scaling
//
// To add a study, write a function from a size to a Sample and a line in `studies`.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <tencer/equilibrium/solve.hpp>
#include <vector>

using namespace tencer;

namespace {

constexpr int most_columns = 8;

// What was measured at one size; columns in the order of the study's names.
struct Sample {
  std::array<double, most_columns> values{};
};

struct Study {
  const char* title;
  const char* size_name;
  std::vector<double> sizes;
  std::vector<const char*> columns;  // of Sample::values; peak memory is added to them
  Sample (*measure)(int size);
};

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// A closed rod of n vertices on a circle, pressed to an oval by spokes to its neighbourhood's
// opposite: 24 cables whatever n is.
struct Model {
  equilibrium::Structure structure;
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

// Columns: whole solve s, iterations, factorisations, one factorisation s, Gflop/s of it, flops of
// it, bytes of its factor.
Sample forward(int n) {
  const Model model = ring_with_cables(n);
  auto begin = std::chrono::steady_clock::now();
  const equilibrium::System system(model.structure);
  equilibrium::Linearisation at;
  const auto result =
      equilibrium::solve(system, make_state(model.structure, {model.start}), {}, at);
  const double whole = seconds_since(begin);

  constexpr int repeats = 3;
  double fastest = whole;
  for (int k = 0; k < repeats; ++k) {
    begin = std::chrono::steady_clock::now();
    at.factor.factorise(at.matrix);
    fastest = std::min(fastest, seconds_since(begin));
  }
  const auto cost = at.factor.cost();
  return {{whole, static_cast<double>(result.iterations),
           static_cast<double>(result.factorisations), fastest, cost.operations / fastest / 1e9,
           cost.operations, cost.bytes, result.usable() ? 1.0 : 0.0}};
}

const std::vector<Study> studies{
    {"Forward solve: one closed rod, 24 cables",
     "n",
     {1e2, 3e2, 1e3, 3e3, 1e4, 3e4, 1e5},
     {"solve s", "iter", "fact", "one fact s", "Gflop/s", "flops", "bytes of L", "usable"},
     forward}};

// Measures in a child; adds the peak of its resident memory in bytes.
std::vector<double> measured(const Study& study, int size) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return {};
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
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
  for (std::size_t i = sizes.size() / 2; i < sizes.size(); ++i) {
    if (!(values[i] > 0)) continue;
    const double x = std::log(sizes[i]), y = std::log(values[i]);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

void print(const Study& study) {
  std::printf("%s\n%10s", study.title, study.size_name);
  for (const char* column : study.columns) std::printf(" %11s", column);
  std::printf(" %11s\n", "peak bytes");
  std::vector<double> sizes;
  std::vector<std::vector<double>> columns(study.columns.size() + 1);
  for (const double size : study.sizes) {
    const auto values = measured(study, static_cast<int>(size));
    std::printf("%10.0f", size);
    if (values.empty()) std::printf(" did not end as it should");
    for (const double value : values) std::printf(" %11.3g", value);
    std::printf("\n");
    if (values.empty()) continue;
    sizes.push_back(size);
    for (std::size_t c = 0; c < columns.size(); ++c) columns[c].push_back(values[c]);
  }
  std::printf("%10s", "exponent");
  for (const auto& column : columns) std::printf(" %11.2f", exponent(sizes, column));
  std::printf("\n\n");
}

}  // namespace

int main() {
  for (const Study& study : studies) print(study);
}
