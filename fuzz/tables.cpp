// CSV: any bytes give rows that are read back as written, or an error that names the file.
#include <cstdint>
#include <tencer/io/csv.hpp>

#include "must.hpp"

using namespace tencer;
using fuzz::must;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto rows = io::parse_csv("table.csv", {reinterpret_cast<const char*>(data), size});
  if (!rows) {
    must(rows.error().where.starts_with("table.csv:"));
    must(!rows.error().message.empty());
    return 0;
  }
  std::string text;
  for (const auto& row : *rows) {
    must(!row.empty());
    text += io::csv_line(row);
  }
  const auto again = io::parse_csv("table.csv", text);
  must(again.has_value());
  must(*again == *rows);
  return 0;
}
