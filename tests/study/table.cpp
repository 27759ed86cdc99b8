// The table of a study: what is written is read again, also by a program with other stages.
#include "study/table.hpp"

#include <catch2/catch.hpp>

using namespace tencer;
using namespace tencer::app::study;

namespace {

Row finished() {
  return {.run = {.scene = "knot",
                  .file = "a, b/knot.toml",
                  .method = "dense-springs",
                  .optimizer = "mma",
                  .resolution = 0.5,
                  .max_error = 0.3},
          .status = "tolerance-not-reached",
          .vertices = 102,
          .cables = 9,
          .external_cables = 2,
          .max_percent = 0.1 + 0.2,
          .rms_percent = 1e-7,
          .seconds = 12.5,
          .stages = {{"prune", 0.5}, {"eliminate", 2}},
          .stands = true,
          .settles = false,
          .smallest_eigenvalue = 3.25e4,
          .machine = "node-7",
          .message = "it \"rests\" elsewhere,\nsay the cables"};
}

Row failed() {
  return {.run = {.scene = "knot",
                  .file = "a, b/knot.toml",
                  .method = "force-balance",
                  .optimizer = "gauss-newton"},
          .status = "failed",
          .seconds = 0.25,
          .message = "out of memory"};
}

}  // namespace

TEST_CASE("rows of a study come back from its table") {
  const std::vector<Row> rows{finished(), failed()};
  const auto read = parse_table("study.csv", table_text(rows));
  if (!read) FAIL(read.error().text());
  REQUIRE(read->size() == 2);
  const Row& first = read->front();
  CHECK(same_run(first.run, rows[0].run));
  CHECK(first.run.file == rows[0].run.file);
  CHECK(first.status == rows[0].status);
  CHECK(first.vertices == 102);
  CHECK(first.cables == 9);
  CHECK(first.external_cables == 2);
  CHECK(first.max_percent == 0.1 + 0.2);
  CHECK(first.rms_percent == 1e-7);
  CHECK(first.seconds == 12.5);
  CHECK(first.stages == rows[0].stages);
  CHECK(first.stands == true);
  CHECK(first.settles == false);
  CHECK(first.smallest_eigenvalue == 3.25e4);
  CHECK(first.machine == "node-7");
  CHECK(first.message == rows[0].message);
  const Row& second = read->back();
  CHECK_FALSE(second.vertices);
  CHECK_FALSE(second.max_percent);
  CHECK_FALSE(second.stands);
  CHECK(second.stages.empty());
  CHECK(second.message == "out of memory");
  CHECK(table_text(*read) == table_text(rows));
}

TEST_CASE("stages have their columns in the order in which runs have them") {
  Row other = finished();
  other.stages = {{"prune", 1}, {"greedy", 2}, {"eliminate", 3}};
  const std::string text = table_text(std::vector{finished(), other});
  CHECK_THAT(text,
             Catch::Matchers::Contains(",seconds,seconds_prune,seconds_greedy,seconds_eliminate,"));
  CHECK_THAT(text, Catch::Matchers::Contains(",12.5,0.5,,2,"));
  CHECK_THAT(text, Catch::Matchers::Contains(",12.5,1,2,3,"));
}

TEST_CASE("a table that is none is refused with its line and column") {
  std::string text = table_text(std::vector{finished()});
  CHECK(parse_table("study.csv", "")->empty());
  CHECK(parse_table("study.csv", "a,b\n1,2\n").error().where == "study.csv:2");
  CHECK(parse_table("study.csv", text + "knot,1\n").error().where == "study.csv:3");
  text.replace(text.find(",102,"), 5, ",many,");
  const auto read = parse_table("study.csv", text);
  REQUIRE_FALSE(read);
  CHECK_THAT(read.error().text(), Catch::Matchers::StartsWith("study.csv:2: vertices: "));
}

TEST_CASE("a design's row has its numbers, stages added up") {
  model::Design design;
  design.status = model::DesignStatus::complete;
  design.structure.rods.resize(2);
  design.target = {Eigen::Matrix3Xd::Zero(3, 20), Eigen::Matrix3Xd::Zero(3, 5)};
  design.structure.cables = {{.a = springs::OnRod{0}, .b = springs::OnRod{1}},
                             {.a = springs::OnRod{0}, .b = springs::AtAnchor{3}}};
  design.built.resize(2);
  design.error = {.max_percent = 0.5, .rms_percent = 0.2};
  design.certificate.emplace();
  design.certificate->smallest_eigenvalue = 900;
  design.certificate->stable = true;
  design.certificate->settles_from_target = true;
  for (const auto& [stage, seconds] :
       {std::pair("balance", 1.0), {"settle", 0.25}, {"settle", 0.5}}) {
    model::StageRow& one = design.trace.emplace_back();
    one.stage = stage;
    one.seconds = seconds;
  }
  const Row row = row_of(failed().run, design, 4);
  CHECK(row.status == "complete");
  CHECK(row.vertices == 25);
  CHECK(row.cables == 2);
  CHECK(row.external_cables == 1);
  CHECK(row.max_percent == 0.5);
  CHECK(row.settles == true);
  CHECK(row.smallest_eigenvalue == 900.0);
  CHECK(row.seconds == 4);
  CHECK(row.stages ==
        std::vector<std::pair<std::string, double>>{{"balance", 1}, {"settle", 0.75}});
}
