#include <tencer/io/design.hpp>
#include <tencer/io/file.hpp>

#include "bad_input.hpp"
#include "design_json.hpp"
#include "json_value.hpp"
#include "pretty_json.hpp"

namespace tencer::io {

core::Expected<Design> read_design(const std::filesystem::path& path) {
  return guarded([&] {
    const std::string text = value_or_fail(read_file(path));
    const nlohmann::json content = JsonValue::parse(text, path.string());
    return design_from_json(JsonValue(content, path.string()));
  });
}

std::string design_text(const Design& design) { return pretty(design_to_json(design)); }

std::optional<core::Error> write_design(const std::filesystem::path& path, const Design& design) {
  const nlohmann::ordered_json content = design_to_json(design);
  const nlohmann::json unordered = content;
  const auto readable =
      guarded([&] { return design_from_json(JsonValue(unordered, path.string())); });
  if (!readable) return readable.error();
  return write_file(path, pretty(content));
}

}  // namespace tencer::io
