// What the command line asks of `tencer design`.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <tencer/core/error.hpp>
#include <tencer/model/allowance.hpp>
#include <tencer/model/scene.hpp>
#include <vector>

#include "edit_input.hpp"
#include "scene_input.hpp"

namespace tencer::app {

struct DesignRequest {
  SceneRequest scene;
  std::filesystem::path output;
  std::optional<model::Method> method;
  std::optional<model::Optimizer> optimizer;
  std::optional<model::SecondDerivatives> hessian;
  std::optional<model::Measure> objective;
  std::vector<double> view;  // x, y and z; empty: the scene's
  std::optional<model::SymmetryUse> symmetry;
  std::optional<int> threads;
  std::optional<double> time;
  std::optional<int> effort;
  EditRequest edit;
  std::vector<std::filesystem::path> pictures;  // beside the one in the folder
  std::optional<double> length_error_mm;
  std::optional<double> attachment_error_mm;
  std::optional<model::Allowance> max_deviation;
  bool trade_off = false;
  bool dry_run = false;
  bool json = false;
  bool force = false;

  // Where the result goes: INPUT-design unless it is said.
  std::filesystem::path folder() const;
};

// An option for each.
void add_design_options(CLI::App& command, const std::shared_ptr<DesignRequest>& request);

// Why a picture that is asked for cannot be written, known before the work is done.
std::optional<core::Error> pictures_problem(const DesignRequest& request);

// The scene with what the command line says in place of it.
core::Expected<model::Scene> requested_scene(const DesignRequest& request);

}  // namespace tencer::app
