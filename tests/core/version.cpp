#include <catch2/catch.hpp>
#include <string>
#include <tencer/core/version.hpp>

TEST_CASE("the version's text is that of its numbers") {
  CHECK(std::string(TENCER_VERSION) == std::to_string(TENCER_VERSION_MAJOR) + "." +
                                           std::to_string(TENCER_VERSION_MINOR) + "." +
                                           std::to_string(TENCER_VERSION_PATCH));
}
