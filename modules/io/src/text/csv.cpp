#include <algorithm>
#include <tencer/io/csv.hpp>

namespace tencer::io {
namespace {

std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  quoted += '"';
  return quoted;
}

// Reads one field and what ends it; false: the quotes are not as they should be.
bool read_field(std::string_view text, std::size_t& at, std::string& field) {
  if (at == text.size() || text[at] != '"') {
    const std::size_t end = std::min(text.find_first_of(",\r\n", at), text.size());
    field = text.substr(at, end - at);
    at = end;
    return true;
  }
  for (++at; at < text.size(); ++at) {
    if (text[at] == '"') {
      if (at + 1 == text.size() || text[at + 1] != '"')
        return ++at == text.size() || text.find_first_of(",\r\n", at) == at;
      ++at;
    }
    field += text[at];
  }
  return false;
}

}  // namespace

std::string csv_line(std::span<const std::string> fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) line += ',';
    line += field(fields[i]);
  }
  line += '\n';
  return line;
}

core::Expected<std::vector<CsvRow>> parse_csv(const std::filesystem::path& path,
                                              std::string_view text) {
  std::vector<CsvRow> rows;
  std::size_t at = 0;
  while (at < text.size()) {
    CsvRow row;
    for (bool more = true; more;) {
      const std::size_t begin = at;
      if (!read_field(text, at, row.emplace_back()))
        return core::Error{
            path.string() + ":" +
                std::to_string(1 + std::ranges::count(text.substr(0, begin), '\n')),
            "a quoted field must end with a quote, and a comma or the line's end after it"};
      more = at < text.size() && text[at] == ',';
      if (more) ++at;
    }
    if (at < text.size() && text[at] == '\r') ++at;
    if (at < text.size() && text[at] == '\n') ++at;
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace tencer::io
