#include <tencer/io/check.hpp>
#include <tencer/io/design.hpp>

#include "fixtures/folder.hpp"
#include "sample_design.hpp"

using namespace tencer;

TEST_CASE("What a check found can be read from the design's file again") {
  const Folder folder;
  model::Design design = sample();
  design.check = model::Check{};
  design.check->stands = model::Stands{.rests = true, .certified = false};
  design.check->forgives = model::Forgives{.length_error = 1,
                                           .attachment_error = 2,
                                           .max_deviation = 5,
                                           .draws = 10,
                                           .percentile_95 = 2.125};
  REQUIRE_FALSE(io::write_design(folder / "design.json", design));
  const auto read = io::read_checked_design(folder / "design.json");
  REQUIRE(read);
  CHECK(read->design.name == design.name);
  REQUIRE(read->check);
  const io::FiledCheck& check = *read->check;
  const model::CheckTerms terms = model::terms_of(design);
  CHECK(check.passed == false);
  CHECK(check.fails == model::shortfalls(*design.check, terms));
  const auto lines = model::sections(*design.check, terms);
  REQUIRE(check.lines.size() == lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    CHECK(check.lines[i].section == lines[i].section);
    CHECK(check.lines[i].text == lines[i].text);
    CHECK(check.lines[i].fails == lines[i].fails);
  }
  REQUIRE(check.tolerance);
  CHECK(check.tolerance->length_error == 1);
  CHECK(check.tolerance->attachment_error == 2);
  CHECK(check.tolerance->percentile_95 == 2.125);
}

TEST_CASE("A part of a check that fails nothing is not passed") {
  const Folder folder;
  model::Design design = sample();
  design.check = model::Check{.converged = model::Converged{.converged = true}};
  REQUIRE_FALSE(io::write_design(folder / "part.json", design));
  const auto part = io::read_checked_design(folder / "part.json");
  REQUIRE(part);
  CHECK_FALSE(part->check->passed);
  CHECK(part->check->fails.empty());
  CHECK_THAT(
      io::check_text(design, *design.check),
      Catch::Contains("\"passed\": null") && Catch::Contains("\"not_looked_at\": [\"stands\""));
  design.check = model::Check{.stands = model::Stands{.rests = true, .certified = true},
                              .forgives = model::Forgives{.max_deviation = 1},
                              .comes_back = model::ComesBack{.pushes = {{.tried = 1, .back = 1}}},
                              .holds = model::Holds{},
                              .weight = model::OwnWeight{},
                              .clear = model::Clear{},
                              .converged = model::Converged{.converged = true}};
  REQUIRE_FALSE(io::write_design(folder / "whole.json", design));
  CHECK(io::read_checked_design(folder / "whole.json")->check->passed == true);
}

TEST_CASE("A deviation that is not finite is none") {
  const Folder folder;
  model::Design design = sample();
  design.check = model::Check{.forgives = model::Forgives{.percentile_95 = no_number}};
  REQUIRE_FALSE(io::write_design(folder / "design.json", design));
  CHECK_FALSE(io::read_checked_design(folder / "design.json")->check->tolerance);
}

TEST_CASE("A design that nobody checked has no check, and one that is broken has an error") {
  const Folder folder;
  REQUIRE_FALSE(io::write_design(folder / "design.json", sample()));
  CHECK_FALSE(io::read_checked_design(folder / "design.json")->check);
  std::string text = io::design_text(sample());
  text.insert(1, R"("check": {"passed": true},)");
  const auto broken = io::read_checked_design(folder.put("broken.json", text));
  REQUIRE_FALSE(broken);
  CHECK(folder.local(broken.error().text()) == "broken.json: check: the key \"fails\" is missing");
}
