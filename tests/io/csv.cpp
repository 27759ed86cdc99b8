#include <catch2/catch.hpp>
#include <tencer/io/csv.hpp>

using tencer::io::csv_line;
using tencer::io::CsvRow;
using tencer::io::parse_csv;

TEST_CASE("rows of any texts come back from CSV") {
  const std::vector<CsvRow> rows{{"scene", "message"},
                                 {"a, b", "it says \"no\"\r\nand no more"},
                                 {"", "\""},
                                 {"one"},
                                 {"", "", ""}};
  std::string text;
  for (const auto& row : rows) text += csv_line(row);
  const auto read = parse_csv("table.csv", text);
  REQUIRE(read);
  CHECK(*read == rows);
}

TEST_CASE("CSV of other programs: line ends of either kind, the last one missing") {
  const auto read = parse_csv("table.csv", "a,b\r\n1,\"2\"\r\n3,");
  REQUIRE(read);
  CHECK(*read == std::vector<CsvRow>{{"a", "b"}, {"1", "2"}, {"3", ""}});
  CHECK(parse_csv("table.csv", "")->empty());
}

TEST_CASE("broken quotes are named by their line") {
  for (const char* text : {"a,b\n1,\"2", "a,b\n1,\"2\"x\n"}) {
    const auto read = parse_csv("table.csv", text);
    REQUIRE_FALSE(read);
    CHECK(read.error().where == "table.csv:2");
  }
}
