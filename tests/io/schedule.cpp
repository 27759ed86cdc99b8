#include <catch2/catch.hpp>
#include <tencer/io/file.hpp>
#include <tencer/io/schedule.hpp>

#include "fixtures/folder.hpp"

using namespace tencer;

namespace {

model::Design with_cables(int count) {
  model::Design design;
  design.length_unit = "cm";
  design.built.assign(static_cast<std::size_t>(count), {.length = 10});
  return design;
}

std::string refusal(const std::string& text) {
  const Folder folder;
  REQUIRE_FALSE(io::write_file(folder / "s.toml", text));
  const auto read = io::read_schedule(folder / "s.toml", with_cables(3));
  return read ? "" : read.error().text();
}

}  // namespace

TEST_CASE("a schedule names cables by their numbers, ranges of them, or all") {
  const Folder folder;
  REQUIRE_FALSE(io::write_file(folder / "s.toml", R"([[step]]
2 = "by -5 mm"
frames = 3
[[step]]
1-2 = "to 50 %"
[[step]]
all = "to 100 %"
)"));
  const auto read = io::read_schedule(folder / "s.toml", with_cables(3));
  REQUIRE(read);
  REQUIRE(read->steps.size() == 3);
  CHECK(read->steps[0].frames == 3);
  CHECK(read->steps[1].frames == 10);
  CHECK_FALSE(read->steps[0].changes[0]);
  CHECK(read->steps[0].changes[1]->amount == -5);
  CHECK(read->steps[1].changes[1]->amount == 50);
  CHECK_FALSE(read->steps[1].changes[2]);
  CHECK(read->steps[2].changes[2]);
}

TEST_CASE("a schedule in memory is read alike, and errors name the key alone") {
  const auto read =
      io::schedule_of_text(R"("step" = [{"2" = "by -5 mm", "frames" = 3}])", with_cables(3));
  REQUIRE(read);
  CHECK(read->steps[0].frames == 3);
  CHECK(read->steps[0].changes[1]->amount == -5);
  const auto none = io::schedule_of_text(R"(step = [{"4" = "by -5 mm"}])", with_cables(3));
  REQUIRE_FALSE(none);
  CHECK(none.error().text() == "step[0].4: the design has no such cable: it has 3 cables, from 1");
}

TEST_CASE("schedules that cannot be followed are refused, with the line") {
  using Catch::Matchers::Contains;
  CHECK_THAT(refusal(""), Contains("has no step"));
  CHECK_THAT(refusal("[[step]]\n4 = \"by -5 mm\"\n"),
             Contains("s.toml:2: step[0].4: the design has no such cable: it has 3 cables"));
  CHECK_THAT(refusal("[[step]]\nfoo = \"by -5 mm\"\n"), Contains("step[0].foo: is no cable"));
  CHECK_THAT(refusal("[[step]]\n1 = \"-5 mm\"\n"), Contains("expected \"by -12 mm\""));
  CHECK_THAT(refusal("[[step]]\n1 = 5\n"), Contains("s.toml:2: step[0].1"));
  CHECK_THAT(refusal("[[step]]\n1 = \"by -10 cm\"\n"), Contains("cable 1 has the length 0"));
  CHECK_THAT(refusal("[[step]]\n1 = \"by -1 mm\"\n1-2 = \"by 1 mm\"\n"),
             Contains("cable 1 is named twice"));
  CHECK_THAT(refusal("[[step]]\nframes = 0\n"), Contains("step[0].frames"));
  CHECK_THAT(refusal("steps = 3\n"), Contains("unknown key steps"));
}
