#include <tencer/io/design.hpp>
#include <tencer/io/file.hpp>

#include "design/design_json.hpp"
#include "design/json_value.hpp"
#include "design/pretty_json.hpp"
#include "text/bad_input.hpp"

namespace tencer::io {

core::Expected<model::Design> read_design(const std::filesystem::path& path) {
  return guarded([&] {
    const std::string text = value_or_fail(read_file(path));
    const nlohmann::json content = JsonValue::parse(text, path.string());
    return design_from_json(JsonValue(content, path.string()));
  });
}

std::string design_text(const model::Design& design) { return pretty(design_to_json(design)); }

std::optional<core::Error> design_problem(const std::filesystem::path& path,
                                          const model::Design& design) {
  const nlohmann::json content = design_to_json(design);
  const auto readable =
      guarded([&] { return design_from_json(JsonValue(content, path.string())); });
  return readable ? std::nullopt : std::optional(readable.error());
}

std::optional<core::Error> write_design(const std::filesystem::path& path,
                                        const model::Design& design) {
  if (auto error = design_problem(path, design)) return error;
  return write_file(path, design_text(design));
}

}  // namespace tencer::io
