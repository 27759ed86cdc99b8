#include <algorithm>
#include <cmath>
#include <tencer/design.hpp>
#include <tencer/io/curve.hpp>
#include <tencer/io/design.hpp>
#include <tencer/io/scene.hpp>
#include <tencer/model/resolution.hpp>
#include <tencer/model/units.hpp>
#include <utility>

namespace tencer {
namespace {

template <class T>
void take(const std::optional<T>& option, T& value) {
  if (option) value = *option;
}

std::optional<std::string> unit_problem(const char* field, const std::optional<std::string>& unit,
                                        std::span<const std::string_view> known) {
  if (!unit || std::ranges::find(known, *unit) != known.end()) return std::nullopt;
  std::string text = std::string(field) + ": expected";
  for (const std::string_view name : known) text += " " + std::string(name);
  return text + ", found " + *unit;
}

// The settings with the options in place of what they say.
void apply(const DesignOptions& options, model::DesignSettings& settings) {
  // Else the scene's number of cables would decide.
  if (options.max_error) settings.cables.reset();
  take(options.max_error, settings.max_error);
  if (options.cables) settings.cables = options.cables;
  take(options.method, settings.method);
  take(options.optimizer, settings.optimizer);
  take(options.hessian, settings.hessian);
  // The scene's may be for another optimizer.
  if (options.optimizer && !options.hessian &&
      model::hessian_problem(settings.optimizer, settings.hessian))
    settings.hessian = model::DesignSettings{}.hessian;
  take(options.objective, settings.objective);
  take(options.symmetry, settings.symmetry);
  if (options.threads) settings.threads = options.threads;
  if (options.time) settings.time = options.time;
  take(options.effort, settings.effort);
}

void apply(const DesignOptions& options, model::BuildSettings& build) {
  if (options.length_error) build.length_error = options.length_error;
  if (options.attachment_error) build.attachment_error = options.attachment_error;
  if (options.max_deviation) build.max_deviation = options.max_deviation;
}

// Of rods that say none.
model::Material material_of(const DesignOptions& options) {
  return options.material ? *model::find_material(*options.material) : model::glass_fibre();
}

// All rods with this section, of a material as stiff as it says.
void set_section(const der::Section& section, model::Scene& scene) {
  for (auto& rod : scene.structure.rods) rod.section = section;
  const auto area = der::area(section.shape);
  if (!area) return;
  const double metre = model::metres(scene.length_unit);
  for (auto& material : scene.structure.materials)
    material.youngs_modulus =
        section.EA / *area * model::newtons(scene.force_unit) / (metre * metre);
}

model::Scene scene_of(const std::vector<Curve>& curves, std::string name,
                      const DesignOptions& options) {
  return model::scene_of(curves, std::move(name), options.length_unit.value_or("cm"),
                         options.force_unit.value_or("N"), material_of(options));
}

}  // namespace

core::Expected<std::vector<Curve>> read_curves(const std::filesystem::path& file) {
  return io::read_curves(file);
}

der::Section round_rod(double youngs_modulus, double radius, double poisson) {
  return der::solid_circle(youngs_modulus, poisson, radius);
}

std::optional<std::string> DesignOptions::problem() const {
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  if (auto wrong = unit_problem("length_unit", length_unit, model::length_units())) return wrong;
  if (auto wrong = unit_problem("force_unit", force_unit, model::force_units())) return wrong;
  if (section && !(positive(section->EA) && positive(section->EI1) && positive(section->EI2) &&
                   positive(section->GJ)))
    return "section: its stiffnesses must be positive numbers";
  if (material && !model::find_material(*material))
    return "material: there is no '" + *material + "'; model::materials() has those that there are";
  if (anchors && !anchors->allFinite()) return "anchors must be finite";
  if (longest_cable && !positive(*longest_cable)) return "longest_cable must be a positive number";
  if (!positive(resolution)) return "resolution must be a positive number";
  model::DesignSettings settings;
  apply(*this, settings);
  if (hessian && optimizer)
    if (const auto wrong = model::hessian_problem(settings.optimizer, settings.hessian))
      return "hessian: " + *wrong;
  model::BuildSettings build;
  apply(*this, build);
  if (auto wrong = build.problem()) return wrong;
  return settings.problem();
}

void DesignOptions::validate() const {
  if (const auto wrong = problem()) throw std::invalid_argument("DesignOptions::" + *wrong);
}

core::Expected<model::Scene> with_options(model::Scene scene, const DesignOptions& options) {
  if (const auto wrong = options.problem()) return core::Error{"DesignOptions", *wrong};
  apply(options, scene.design);
  apply(options, scene.build);
  if (options.hessian)
    if (const auto wrong = model::hessian_problem(scene.design.optimizer, scene.design.hessian))
      return core::Error{"DesignOptions", "hessian: " + *wrong};
  if (options.section) set_section(*options.section, scene);
  take(options.anchors, scene.structure.anchors);
  if (options.rod_pairs) scene.rules.pairs = options.rod_pairs;
  take(options.longest_cable, scene.rules.max_cable_length);
  return model::at_resolution(scene, options.resolution);
}

core::Expected<model::Design> design(const model::Scene& scene, const DesignOptions& options) {
  const auto asked = with_options(scene, options);
  if (!asked) return asked.error();
  return pipeline::design(*asked, options.run);
}

core::Expected<model::Design> design(const std::vector<Curve>& curves,
                                     const DesignOptions& options) {
  if (const auto wrong = options.problem()) return core::Error{"DesignOptions", *wrong};
  if (curves.empty()) return core::Error{"curves", "there are none"};
  return design(scene_of(curves, "design", options), options);
}

core::Expected<model::Design> design(const std::filesystem::path& file,
                                     const DesignOptions& options) {
  if (const auto wrong = options.problem()) return core::Error{"DesignOptions", *wrong};
  const auto scene = io::read_any_scene(file, {.material = material_of(options),
                                               .length_unit = options.length_unit,
                                               .force_unit = options.force_unit});
  return scene ? design(*scene, options) : core::Expected<model::Design>(scene.error());
}

core::Expected<model::Scene> read_scene(const std::filesystem::path& file) {
  return io::read_any_scene(file);
}

std::optional<core::Error> write_design(const std::filesystem::path& file,
                                        const model::Design& design) {
  return io::write_design(file, design);
}

}  // namespace tencer
