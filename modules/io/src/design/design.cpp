#include <tencer/io/design.hpp>
#include <tencer/io/file.hpp>

#include "curves/curve_format.hpp"
#include "design/design_json.hpp"
#include "design/json_value.hpp"
#include "design/parse_design.hpp"
#include "design/pretty_json.hpp"
#include "design/published_json.hpp"
#include "text/bad_input.hpp"
#include "text/read_text.hpp"

namespace tencer::io {

bool is_design(const nlohmann::json& content) {
  return content.is_object() &&
         (content.contains("schema") || is_published(content) || is_program_state(content));
}

model::Design any_design(const JsonValue& root, const std::filesystem::path& path) {
  const bool published = is_published(root.raw());
  if (!published && !is_program_state(root.raw())) return design_from_json(root);
  model::Design design = published ? design_from_published(root) : design_from_program_state(root);
  if (design.name.empty()) design.name = stem(path);
  return design;
}

nlohmann::json parse_design(const std::filesystem::path& path) {
  const std::string text = read_text(path);
  const bool scene = path.extension() == ".toml";
  if (scene || format_of(path, text, shown(path)) != CurveFormat::json) {
    const std::string what = scene ? "is a scene" : "is a curve";
    fail(shown(path), what + ", and a design is needed; design its cables first: tencer design " +
                          path.string());
  }
  return JsonValue::parse(text, shown(path));
}

core::Expected<model::Design> read_design(const std::filesystem::path& path) {
  return guarded([&] {
    const nlohmann::json content = parse_design(path);
    return any_design(JsonValue(content, shown(path)), path);
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
