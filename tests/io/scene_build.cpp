// What a scene says of how the design is built.
#include <catch2/catch.hpp>
#include <tencer/io/scene.hpp>

#include "fixtures/folder.hpp"

using namespace tencer;
using Catch::Matchers::Contains;

namespace {

core::Expected<model::Scene> scene(const Folder& folder, const std::string& build,
                                   const std::string& unit = "cm") {
  return io::read_scene(
      folder.put("s.toml", "length_unit = '" + unit + "'\n[[rod]]\nfamily = 'circle'\n" + build));
}

}  // namespace

TEST_CASE("errors are a millimetre and two unless the scene says others, in its own unit") {
  const Folder folder;
  for (const auto& [unit, millimetre] : {std::pair("mm", 1.0), {"cm", 0.1}, {"m", 1e-3}}) {
    const auto standard = scene(folder, "", unit);
    REQUIRE(standard);
    CHECK(standard->build.length_error_in(unit) == Approx(millimetre));
    CHECK(standard->build.attachment_error_in(unit) == Approx(2 * millimetre));
  }
  const auto own = scene(folder, "[build]\nlength_error = 0\nattachment_error = 0.3\n");
  REQUIRE(own);
  CHECK(own->build.length_error_in("cm") == 0);
  CHECK(own->build.attachment_error_in("cm") == 0.3);
  // Nothing is known of errors in a unit that is not known.
  CHECK(model::BuildSettings{}.length_error_in("furlong") == 0);
}

TEST_CASE("gaps are those of the scene, and none between layers") {
  const Folder folder;
  const auto own = scene(folder,
                         "[build]\nclearance = 0.5\nmark_distance = 2\nmax_deviation = 3\n"
                         "min_tension_ratio = 0.1\nmin_tension = 4\n");
  REQUIRE(own);
  const auto gaps = own->build.gaps();
  REQUIRE(gaps);
  CHECK(gaps->from_axis(1) == 1.5);
  CHECK(gaps->between_marks(1) == 2);
  REQUIRE(own->build.max_deviation);
  CHECK(own->build.max_deviation->length("cm", 50) == Approx(1.5));
  CHECK(own->build.min_tension_ratio == 0.1);
  CHECK(own->build.min_tension == 4.0);
  const auto layers = scene(folder, "[build]\nlayers = true\n");
  REQUIRE(layers);
  CHECK_FALSE(layers->build.gaps());
}

TEST_CASE("what errors may do is a length or a part of the target's size, in any unit") {
  const Folder folder;
  for (const auto& [text, unit, length] : {std::tuple("'2 mm'", "cm", 0.2),
                                           {"'0.5cm'", "mm", 5.0},
                                           {"'0.001 m'", "mm", 1.0},
                                           {"'2 %'", "cm", 1.0},
                                           {"2", "m", 1.0},
                                           {"'2'", "m", 1.0}}) {
    const auto read = scene(folder, "[build]\nmax_deviation = " + std::string(text) + "\n", unit);
    REQUIRE(read);
    REQUIRE(read->build.max_deviation);
    CHECK(read->build.max_deviation->length(unit, 50) == Approx(length));
  }
}

TEST_CASE("settings that make no sense are named") {
  const Folder folder;
  for (const auto& [line, message] :
       {std::pair("length_error = -1", "s.toml:5: build.length_error"),
        {"max_deviation = 0", "s.toml:5: build.max_deviation"},
        {"max_deviation = '2 inches'",
         "s.toml:5: build.max_deviation: expected a number, in %, or a length such as \"2 mm\", "
         "found \"2 inches\""},
        {"min_tension_ratio = 1", "build.min_tension_ratio: must be less than 1"},
        {"layers = 1", "s.toml:5: build.layers"},
        {"clearence = 1", "did you mean clearance?"}}) {
    const auto wrong = scene(folder, "[build]\n" + std::string(line) + "\n");
    REQUIRE_FALSE(wrong);
    CHECK_THAT(wrong.error().text(), Contains(message));
  }
  // Also those of a program.
  model::BuildSettings settings;
  CHECK_FALSE(settings.problem());
  settings.clearance = -1;
  CHECK(settings.problem() == "clearance must not be negative");
  settings = {.max_deviation = model::Allowance{.amount = 0}};
  CHECK(settings.problem() == "max_deviation must be a positive number, in %, mm, cm or m");
  settings = {.min_tension_ratio = 1.0};
  CHECK(settings.problem() == "min_tension_ratio must be at least 0 and less than 1");
}
