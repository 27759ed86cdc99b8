#include "rates.hpp"

#include <algorithm>
#include <array>
#include <ctime>
#include <vector>

namespace bench {
namespace {

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// The best of some runs: whatever else the machine does only slows one.
template <class Run>
double best_rate(double amount, const Run& run) {
  constexpr double budget = 0.3;  // seconds
  double best = 0;
  const double begin = cpu_seconds();
  while (cpu_seconds() - begin < budget) {
    const double start = cpu_seconds();
    run();
    best = std::max(best, amount / (cpu_seconds() - start));
  }
  return best;
}

volatile double sink = 0;  // so that nothing measured is left out

}  // namespace

double flop_rate() {
  constexpr int lanes = 64, rounds = 100'000;  // enough to hide how long each takes
  std::array<double, lanes> values{};
  values.fill(1);
  return best_rate(2.0 * lanes * rounds, [&] {
    const double factor = 1 - 1e-9 * sink, term = 1e-9 * sink;
    std::array<double, lanes> x = values;
    for (int k = 0; k < rounds; ++k)
      for (double& entry : x) entry = entry * factor + term;
    double sum = 0;
    for (const double entry : x) sum += entry;
    sink = sum / lanes;
  });
}

double read_rate(std::size_t bytes) {
  constexpr std::size_t lanes = 32;
  const std::size_t count = std::max(bytes / sizeof(double) / lanes, std::size_t{1}) * lanes;
  const std::vector<double> data(count, 1.0);
  const int repeats = static_cast<int>(std::max(std::size_t{1}, 1'000'000 / count));
  return best_rate(static_cast<double>(count * sizeof(double)) * repeats, [&] {
    std::array<double, lanes> sums{};
    for (int k = 0; k < repeats; ++k)
      for (std::size_t i = 0; i < count; i += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane) sums[lane] += data[i + lane];
    for (const double sum : sums) sink = sink + sum;
  });
}

}  // namespace bench
