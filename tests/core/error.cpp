#include <catch2/catch.hpp>
#include <memory>
#include <tencer/core/error.hpp>

using namespace tencer::core;

TEST_CASE("an Expected holds a value or the error that prevented it") {
  const Expected<int> good = 7;
  REQUIRE(good);
  CHECK(good.has_value());
  CHECK(*good == 7);
  CHECK_THROWS_AS(good.error(), std::bad_variant_access);

  const Expected<int> bad = Error{.where = "scene.toml:3", .message = "not a number"};
  REQUIRE_FALSE(bad);
  CHECK(bad.error().text() == "scene.toml:3: not a number");
  CHECK_THROWS_AS(bad.value(), std::bad_variant_access);
}

TEST_CASE("a value that cannot be copied can be taken out of an Expected") {
  Expected<std::unique_ptr<int>> holder = std::make_unique<int>(5);
  const std::unique_ptr<int> taken = *std::move(holder);
  CHECK(*taken == 5);
}

TEST_CASE("an error without a place is its message") {
  CHECK(Error{.where = {}, .message = "no such optimizer"}.text() == "no such optimizer");
}

TEST_CASE("a precondition that does not hold is the caller's mistake") {
  CHECK_NOTHROW(require(true, "fine"));
  CHECK_THROWS_WITH(require(false, "align: needs points"), "align: needs points");
  CHECK_THROWS_AS(require(false, "align: needs points"), std::invalid_argument);
}
