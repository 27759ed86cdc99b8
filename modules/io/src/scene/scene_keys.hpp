// Keys of a scene that a program says, put where a scene file has them.
#pragma once

#include <toml++/toml.h>

#include <string_view>
#include <tencer/io/curve.hpp>
#include <tencer/io/scene.hpp>

#include "scene/parse_scene.hpp"

namespace tencer::io {

// All of these throw BadInput.

// The keys of SceneKeys::text, those of [design] in its table, and those of [[rod]] that hold for
// all rods by themselves.
struct SortedKeys {
  toml::table root{};
  toml::table every_rod{};
};
SortedKeys sorted_keys(std::string_view text);

// Puts the keys in place of the root's own: in all its rods, or, where they have `rod`, in those
// that do not say them.
void take_keys(SortedKeys keys, toml::table& root);

// The scene of a bare curve file with these keys. source: without curves.
model::Scene scene_of_bare(CurveFile file, SortedKeys keys, SceneSource source);

// What they say of a scene whose rods are there already.
void read_keys_beside_rods(const SortedKeys& keys, const SceneSource& source, model::Scene& scene);

}  // namespace tencer::io
