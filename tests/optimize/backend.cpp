#include <catch2/catch.hpp>
#include <tencer/optimize/backend.hpp>
#include <vector>

using namespace tencer::optimize;

TEST_CASE("a backend is found by its name") {
  const std::vector<Backend> backends{{.name = "mma", .description = "a"},
                                      {.name = "ccsaq", .description = "b"}};
  const auto found = find_backend(backends, "ccsaq");
  REQUIRE(found.has_value());
  CHECK(found->description == "b");
}

TEST_CASE("asking for a backend that is not built names those that are") {
  const std::vector<Backend> backends{{.name = "mma", .description = "a"},
                                      {.name = "ccsaq", .description = "b"}};
  const auto missing = find_backend(backends, "ipopt");
  REQUIRE_FALSE(missing.has_value());
  CHECK(missing.error().text() ==
        "optimizer \"ipopt\" is not in this build; this build has: mma, ccsaq");
  CHECK(find_backend({}, "mma").error().text() ==
        "optimizer \"mma\" is not in this build; this build has: none");
}
