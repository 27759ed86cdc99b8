#include "design/design_request.hpp"

#include <string>
#include <tencer/model/units.hpp>
#include <tencer/pipeline/backends.hpp>

#include "command.hpp"
#include "drawing/picture.hpp"

namespace tencer::app {
namespace {

// Options that leave nothing to each other.
std::optional<core::Error> contradiction(const DesignRequest& request) {
  if (request.trade_off && request.scene.cables)
    return core::Error{"--cables",
                       "--trade-off designs every number of cables; drop --cables for "
                       "all of them, or --trade-off for this one"};
  if (request.trade_off && (request.edit.add || request.edit.remove))
    return core::Error{request.edit.add ? "--add" : "--remove",
                       "asks for one number of cables, --trade-off for all; drop one of them"};
  return std::nullopt;
}

// The optimizer and the hessian asked for in place of the scene's.
std::optional<core::Error> apply_optimizer(const DesignRequest& request,
                                           model::DesignSettings& settings) {
  if (request.optimizer) {
    const auto known =
        optimize::find_backend(pipeline::backends(), model::name_of(*request.optimizer));
    if (!known) return core::Error{"--optimizer", known.error().message};
    settings.optimizer = *request.optimizer;
  }
  if (request.hessian) {
    settings.hessian = *request.hessian;
    for (const auto& problem : {model::hessian_problem(settings.optimizer, settings.hessian),
                                model::hessian_problem(settings.method, settings.hessian)})
      if (problem) return core::Error{"--hessian", *problem};
  } else if (request.optimizer && model::hessian_problem(settings.optimizer, settings.hessian)) {
    settings.hessian = model::DesignSettings{}.hessian;  // the scene's was for another optimizer
  }
  return std::nullopt;
}

// Options in place of the scene's keys.
std::optional<core::Error> apply(const DesignRequest& request, model::DesignSettings& settings) {
  if (request.method) settings.method = *request.method;
  if (auto error = apply_optimizer(request, settings)) return error;
  if (request.trade_off) settings.cables.reset();  // else the scene's number would decide
  if (request.objective) settings.objective = *request.objective;
  if (request.symmetry) settings.symmetry = *request.symmetry;
  if (request.threads) settings.threads = *request.threads;
  if (request.time) settings.time = *request.time;
  if (request.effort) settings.effort = *request.effort;
  if (request.symmetry == model::SymmetryUse::detect &&
      settings.method != model::Method::force_balance)
    return core::Error{"--symmetry",
                       "networks of the method " + std::string(model::name_of(settings.method)) +
                           " do not keep symmetries; use none, or --method force-balance"};
  return std::nullopt;
}

void apply_errors(const DesignRequest& request, model::Scene& scene) {
  const double millimetre = 1e-3 / model::metres(scene.length_unit);
  if (request.length_error_mm) scene.build.length_error = *request.length_error_mm * millimetre;
  if (request.attachment_error_mm)
    scene.build.attachment_error = *request.attachment_error_mm * millimetre;
  if (request.max_deviation) scene.build.max_deviation = request.max_deviation;
}

// How the cables are searched for.
void add_search(CLI::App& command, DesignRequest& request) {
  const model::DesignSettings standard;
  add_choice(command, "--objective", request.objective,
             "Which of the distances to the target is made small", standard.objective);
  command
      .add_option("--view", request.view,
                  "Along x,y,z: distances to the target count as they are seen in this direction "
                  "[the scene's, else in space]")
      ->delimiter(',')
      ->expected(3)
      ->type_name("X,Y,Z");
  add_choice(command, "--symmetry", request.symmetry,
             "Whether the cables keep the target's symmetries, or you are told of them",
             standard.symmetry, {model::SymmetryUse::given});
  add_choice(command, "--method", request.method, "The way to a network", standard.method);
  add_choice(command, "--optimizer", request.optimizer,
             "Who makes the last fit, and in dense-springs all of them", standard.optimizer);
  add_choice(command, "--hessian", request.hessian,
             "What gauss-newton or ipopt is told of curvature", standard.hessian);
  command
      .add_option("--threads", request.threads,
                  "How many threads share the work; the design is the same [the scene's, else as "
                  "many as the machine has]")
      ->check(positive_integer());
  command
      .add_option("--time", request.time,
                  "Seconds after which the search ends with the best so far; the last checks "
                  "follow [the scene's, else until it stops to pay]")
      ->check(positive_number());
  command
      .add_option("--effort", request.effort,
                  "Of the search: 1 quick, 2, 3 thorough [the scene's, else 2]")
      ->check(CLI::Range(1, 3));
}

// The errors of who builds it.
void add_errors(CLI::App& command, const std::shared_ptr<DesignRequest>& request) {
  command
      .add_option("--length-error", request->length_error_mm,
                  "To how many mm cables are cut: the design forgives it [the scene's, else 1]")
      ->check(not_negative_number());
  command
      .add_option("--attachment-error", request->attachment_error_mm,
                  "To how many mm they are tied along the rods, likewise [the scene's, else 2]")
      ->check(not_negative_number());
  command
      .add_option_function<std::string>(
          "--max-deviation",
          [request](const std::string& text) {
            request->max_deviation = model::read_allowance(text);
          },
          "What these errors may move of 95 in 100 built so: 5mm, or 1% of the size [the scene's, "
          "else the max error]")
      ->check(allowance());
}

}  // namespace

std::filesystem::path DesignRequest::folder() const {
  if (!output.empty()) return output;
  return (scene.input == "-" ? "stdin" : scene.input.stem().string()) + "-design";
}

void add_design_options(CLI::App& command, const std::shared_ptr<DesignRequest>& request) {
  command.add_option("-o,--output", request->output, "Folder for the result [INPUT-design]");
  add_force(command, request->force);
  add_scene(command, request->scene,
            "The closest design with at most so many, however far from the target");
  command.add_flag("--trade-off", request->trade_off,
                   "Design every number of cables, and list how close each comes");
  add_search(command, *request);
  add_edit(command, request->edit);
  add_errors(command, request);
  command
      .add_option("--picture", request->pictures,
                  "Also draw it into this file, .svg, .pdf or .png; may be given several times")
      ->allow_extra_args(false);
  command.add_flag("--json", request->json,
                   "Write the result as JSON instead of words, without the rods' points");
  command
      .add_flag("--dry-run", request->dry_run,
                "Only say what was understood, what this scene needs, and what is left out and why")
      ->excludes("--json");
}

std::optional<core::Error> pictures_problem(const DesignRequest& request) {
  std::error_code ignored;
  for (const std::filesystem::path& picture : request.pictures) {
    if (auto error = picture_problem(picture)) return error;
    const std::filesystem::path folder = std::filesystem::absolute(picture).parent_path();
    if (!std::filesystem::is_directory(folder, ignored) &&
        folder != std::filesystem::absolute(request.folder() / "x").parent_path())
      return core::Error{picture.string(), "there is no folder " + folder.string()};
  }
  return std::nullopt;
}

namespace {

std::optional<core::Error> apply_view(const DesignRequest& request, model::Scene& scene) {
  if (request.view.empty()) return std::nullopt;
  scene.target.views = {{.direction = Eigen::Vector3d(request.view.data())}};
  if (model::view_problem(scene.target.views))
    return core::Error{"--view", "expected a direction x,y,z that is not zero, such as 0,0,1"};
  if (scene.structure.planar)
    return core::Error{"--view", "a planar scene is seen along z as it is: leave it out"};
  return std::nullopt;
}

}  // namespace

core::Expected<model::Scene> requested_scene(const DesignRequest& request) {
  if (const auto error = contradiction(request)) return *error;
  auto scene = requested_scene(request.scene);
  if (!scene) return scene;
  if (const auto error = apply(request, scene->design)) return *error;
  if (const auto error = apply_view(request, *scene)) return *error;
  apply_errors(request, *scene);
  if (const auto error = apply(request.edit, request.scene.cables.has_value(), *scene))
    return *error;
  return scene;
}

}  // namespace tencer::app
