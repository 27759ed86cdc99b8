// What commands that design take: a scene, or a bare curve with every default, and what the command
// line says in place of it.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/model/material.hpp>
#include <tencer/model/scene.hpp>

namespace tencer::app {

struct SceneRequest {
  std::filesystem::path input;  // what io::read_any_scene reads
  std::string material = model::glass_fibre().name;
  bool closed = false;              // of a bare curve
  std::optional<std::string> unit;  // likewise
  std::optional<double> smooth;
  std::optional<double> max_error;
  std::optional<int> cables;
  double resolution = 1.0;
};

// INPUT and an option for each of the others. cables: what --cables helps with.
void add_scene(CLI::App& command, SceneRequest& request, const std::string& cables);

// A max error comes before the scene's number of cables.
core::Expected<model::Scene> requested_scene(const SceneRequest& request);

}  // namespace tencer::app
