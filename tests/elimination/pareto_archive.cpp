#include "multistart/pareto_archive.hpp"

#include <catch2/catch.hpp>

using namespace tencer;
using elimination::ParetoArchive;
using elimination::Solution;
using model::Footing;

namespace {

Solution solution(int cables, double percent, Footing footing) {
  Solution result{
      .max_percent = percent, .rms_percent = percent / 2, .standing = {.footing = footing}};
  result.network.structure.cables.resize(cables);
  return result;
}

}  // namespace

TEST_CASE("an archive keeps of each number of cables the closest, and the closest that stands") {
  ParetoArchive archive;
  archive.add(solution(6, 2.0, Footing::none));
  archive.add(solution(6, 1.0, Footing::none));
  archive.add(solution(6, 1.5, Footing::stands));
  archive.add(solution(6, 1.8, Footing::stands));
  archive.add(solution(8, 0.5, Footing::stands));
  // Of each number the one that stands.
  const auto best = archive.best();
  REQUIRE(best.size() == 2);
  CHECK(best[0].max_percent == 1.5);
  CHECK(best[1].max_percent == 0.5);
  // The closest still answers where none that stands is near enough.
  ParetoArchive other;
  other.add(archive);
  other.add(solution(6, 0.5, Footing::none));
  CHECK(other.best_for({.cables = 6})->max_percent == 0.5);
  CHECK(archive.best_for({.cables = 6})->max_percent == 1.5);
}

TEST_CASE("networks further away than one with fewer cables are not among the best") {
  ParetoArchive archive;
  archive.add(solution(5, 1.0, Footing::stands));
  archive.add(solution(6, 1.2, Footing::stands));
  archive.add(solution(7, 0.8, Footing::stands));
  const auto best = archive.best();
  REQUIRE(best.size() == 2);
  CHECK(best[0].cables() == 5);
  CHECK(best[1].cables() == 7);
}

TEST_CASE("the first that stands is among the best, however close those with fewer cables are") {
  ParetoArchive archive;
  archive.add(solution(5, 0.5, Footing::none));
  archive.add(solution(6, 0.9, Footing::stands));
  archive.add(solution(7, 0.7, Footing::stands));
  const auto best = archive.best();
  REQUIRE(best.size() == 3);
  CHECK(best[1].cables() == 6);
  CHECK(archive.best_for({.max_error_percent = 1.0})->cables() == 6);
}

TEST_CASE("an archive answers a goal, and an empty one does not") {
  ParetoArchive archive;
  CHECK(archive.best_for({}) == nullptr);
  archive.add(solution(5, 3.0, Footing::stands));
  archive.add(solution(7, 0.9, Footing::none));
  archive.add(solution(9, 0.8, Footing::stands));
  // Within 1 % only the one with 9 cables stands; with 7 at most the closest does.
  CHECK(archive.best_for({.max_error_percent = 1.0})->cables() == 9);
  CHECK(archive.best_for({.cables = 7})->cables() == 7);
  CHECK(archive.best_for({.cables = 4})->cables() == 5);
}

TEST_CASE("what keeps its pose comes before what falls, and what stands before both") {
  ParetoArchive archive;
  archive.add(solution(5, 0.5, Footing::none));
  archive.add(solution(7, 0.9, Footing::keeps));
  CHECK(archive.best_for({.max_error_percent = 1.0})->cables() == 7);
  archive.add(solution(9, 0.9, Footing::stands));
  CHECK(archive.best_for({.max_error_percent = 1.0})->cables() == 9);
  CHECK(archive.best().size() == 3);
  // What is too far away is no answer, however firm.
  CHECK(archive.best_for({.max_error_percent = 0.7})->cables() == 5);
}
