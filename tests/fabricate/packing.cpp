#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <random>
#include <tencer/fabricate/packing.hpp>

using namespace tencer::fabricate;

TEST_CASE("Pieces that fill bars exactly fill them") {
  const std::vector<double> pieces{1, 2, 1, 2, 0.3, 0.7};
  const Packing packing = pack(pieces, 3);
  CHECK(packing.bars.size() == 3);
  CHECK(packing.lower_bound == 3);
  // A tenth has no exact binary form.
  CHECK(pack(std::vector<double>(10, 0.1), 1).bars.size() == 1);
  CHECK(pack(std::vector<double>(10, 0.1), 1).lower_bound == 1);
}

TEST_CASE("Pieces longer than half a bar have one each") {
  const Packing packing = pack(std::vector<double>{0.6, 0.6, 0.6, 0.1}, 1);
  CHECK(packing.lower_bound == 3);
  CHECK(packing.bars.size() == 3);
}

TEST_CASE("Every piece is in one bar, no bar is overfull, and few are more than there must be") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> length(0.01, 1.0);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> pieces(1 + trial % 60);
    for (double& piece : pieces) piece = length(random);
    const Packing packing = pack(pieces, 1.0);
    std::vector<int> seen;
    for (const auto& bar : packing.bars) {
      double sum = 0;
      for (const int piece : bar) sum += pieces[piece];
      CHECK(sum <= 1 + 1e-9);
      CHECK(std::ranges::is_sorted(bar, std::greater{}, [&](int p) { return pieces[p]; }));
      seen.insert(seen.end(), bar.begin(), bar.end());
    }
    std::ranges::sort(seen);
    std::vector<int> all(pieces.size());
    std::iota(all.begin(), all.end(), 0);
    CHECK(seen == all);
    const auto bars = static_cast<int>(packing.bars.size());
    CHECK(bars >= packing.lower_bound);
    // Any two bars together hold more than one bar's worth.
    CHECK(bars <= 2 * std::accumulate(pieces.begin(), pieces.end(), 0.0) + 1);
  }
}

TEST_CASE("A rod longer than the stock is made of whole bars and the rest") {
  CHECK(spliced(900, 1000, 20) == std::vector<double>{900});
  CHECK(spliced(1000, 1000, 20) == std::vector<double>{1000});
  CHECK(spliced(2500, 1000, 0) == std::vector<double>{1000, 1000, 500});
  const auto pieces = spliced(2500, 1000, 20);
  CHECK(pieces == std::vector<double>{1000, 1000, 540});
}

TEST_CASE("What cannot be packed is refused") {
  CHECK_THROWS_AS(pack(std::vector<double>{1.1}, 1), std::invalid_argument);
  CHECK_THROWS_AS(pack(std::vector<double>{0.0}, 1), std::invalid_argument);
  CHECK_THROWS_AS(pack(std::vector<double>{0.5}, std::nan("")), std::invalid_argument);
  CHECK_THROWS_AS(spliced(2, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(spliced(-1, 1, 0), std::invalid_argument);
}
