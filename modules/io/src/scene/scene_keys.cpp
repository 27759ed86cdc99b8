#include "scene/scene_keys.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "scene/vertex_limit.hpp"
#include "text/bad_input.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

bool among(std::span<const std::string_view> keys, std::string_view key) {
  return std::ranges::find(keys, key) != keys.end();
}

void put(toml::table& into, std::string_view key, toml::node& value) {
  value.visit([&](auto& concrete) { into.insert_or_assign(key, std::move(concrete)); });
}

toml::table& table_in(toml::table& root, std::string_view key) {
  if (!root.get(key) || !root.get(key)->is_table()) root.insert_or_assign(key, toml::table());
  return *root.get(key)->as_table();
}

// Tables key by key, and what they hold as it is.
void put_all(toml::table& from, toml::table& into) {
  for (auto&& [key, value] : from) put(into, key.str(), value);
}

[[noreturn]] void fail_unknown(std::string_view key) {
  std::vector<std::string_view> known(root_keys.begin(), root_keys.end());
  known.insert(known.end(), design_keys.begin(), design_keys.end());
  known.insert(known.end(), rod_keys.begin(), rod_keys.end());
  fail("", "unknown key " + std::string(key) + "; " + suggestion(key, known));
}

// For each curve a rod table that names it by its number.
toml::array numbered_rods(std::size_t count) {
  toml::array rods;
  for (std::size_t i = 0; i < count; ++i)
    rods.push_back(toml::table{{"curve", static_cast<std::int64_t>(i)}});
  return rods;
}

void put_in_rods(const toml::table& keys, bool override, toml::array& rods) {
  for (toml::node& node : rods)
    if (toml::table* rod = node.as_table())
      for (const auto& [key, value] : keys)
        if (override || !rod->contains(key.str()))
          value.visit([&, &name = key](const auto& concrete) {
            rod->insert_or_assign(name.str(), concrete);
          });
}

}  // namespace

SortedKeys sorted_keys(std::string_view text) {
  toml::table said = TomlTable::parse(text, "");
  SortedKeys keys;
  for (auto&& [key, value] : said)
    if (among(root_keys, key.str()))
      put(keys.root, key.str(), value);
    else if (among(rod_keys, key.str()))
      put(keys.every_rod, key.str(), value);
    else if (!among(design_keys, key.str()))
      fail_unknown(key.str());
  for (auto&& [key, value] : said)
    if (among(design_keys, key.str())) put(table_in(keys.root, "design"), key.str(), value);
  return keys;
}

void take_keys(SortedKeys keys, toml::table& root) {
  if (toml::table* asked = keys.root["design"].as_table())
    if (toml::table* design = root["design"].as_table())
      if (asked->contains("max_error")) design->erase("cables");
  const bool own_rods = keys.root.contains("rod");
  for (auto&& [key, value] : keys.root) {
    toml::table* own = root[key.str()].as_table();
    if (own && value.is_table())
      put_all(*value.as_table(), *own);
    else
      put(root, key.str(), value);
  }
  if (!root.contains("rod") && !keys.every_rod.empty())
    root.insert_or_assign("rod", toml::array{toml::table()});
  if (toml::array* rods = root["rod"].as_array()) put_in_rods(keys.every_rod, !own_rods, *rods);
}

model::Scene scene_of_bare(CurveFile file, SortedKeys keys, SceneSource source) {
  // Inches and feet, which a scene does not have, are units of curves.
  std::optional<std::string> unit = file.length_unit;
  if (const auto said = keys.root["length_unit"].value<std::string>(); said) {
    unit = said;
  } else if (unit) {
    file.notes.push_back("the file says that its numbers are " + *unit);
  }
  if (unit && among(curve_units(), *unit)) {
    take_unit(file, *unit);
    keys.root.insert_or_assign("length_unit", *file.length_unit);
  }
  if (!keys.every_rod.contains("closed"))
    file.notes.insert(file.notes.end(), file.open_ends.begin(), file.open_ends.end());
  limit_vertices(file.curves, source.shown, file.notes);
  source.rods.curves = file.curves;
  toml::table root{{"rod", numbered_rods(file.curves.size())}};
  take_keys(std::move(keys), root);
  model::Scene scene = read_root(TomlTable(root), source);
  scene.notes.insert(scene.notes.begin(), file.notes.begin(), file.notes.end());
  return scene;
}

void read_keys_beside_rods(const SortedKeys& keys, const SceneSource& source, model::Scene& scene) {
  const TomlTable root(keys.root);
  for (const std::string_view key : {"rod", "length_unit", "force_unit", "gravity"})
    if (root.has(key)) root.fail(key, "is said by the design already, with its rods");
  if (!keys.every_rod.empty())
    fail("", std::string(keys.every_rod.begin()->first.str()) +
                 ": the rods are those of the design, as they are");
  scene.name = root.text("name").value_or(scene.name);
  read_task(root, source, scene);
}

core::Expected<model::Scene> scene_of_keys(const SceneKeys& keys, const std::string& name) {
  return guarded([&] {
    SortedKeys said = sorted_keys(keys.text);
    const SceneSource source{.name = name,
                             .shown = name,
                             .rods = {.curves = keys.curves, .material = model::glass_fibre()},
                             .designs = keys.designs};
    toml::table root;
    take_keys(std::move(said), root);
    return read_root(TomlTable(root), source);
  });
}

}  // namespace tencer::io
