// tencer target FAMILY: writes target curves of the built-in families.
#include <algorithm>
#include <iostream>
#include <memory>
#include <span>
#include <tencer/curves/families.hpp>
#include <tencer/io/curve.hpp>
#include <tencer/io/write_curves.hpp>
#include <tencer/random_targets/random_knot.hpp>

#include "command.hpp"

namespace tencer::app {
namespace {

constexpr const char* target_examples = R"(Examples:
  tencer target trefoil-hypotrochoid -o trefoil.obj
  tencer target knot-5_2 --vertices 200 -o knot.obj
  tencer target torus-knot --p 5 --q 3 --vertices 201 -o knot.obj
  tencer target random-knot --cables 12 --seed 7 > knot.obj)";

struct FamilyRequest {
  curves::Family family;
  std::vector<double> values;  // one for each of the family's parameters
  int vertices = 0;
  std::string output;
};

// As OBJ to standard output when there is no file name.
core::Expected<ExitCode> write_curves(const std::string& output,
                                      std::span<const geometry::Polyline> curves) {
  if (output.empty()) {
    std::cout << io::obj_text(curves) << std::flush;
  } else if (const auto error = io::write_curves(output, curves, "cm")) {
    return *error;
  }
  return ExitCode::ok;
}

core::Expected<ExitCode> write_family(const FamilyRequest& request) {
  if (const auto problem = curves::family_problem(request.family, request.values, request.vertices))
    return core::Error{"target " + std::string(request.family.name), *problem};
  const auto curves = curves::family_curves(request.family, request.values, request.vertices);
  return write_curves(request.output, curves);
}

struct KnotRequest {
  random_targets::RandomKnotOptions options;
  std::string output;
};

core::Expected<ExitCode> write_random_knot(const KnotRequest& request) {
  if (const auto problem = random_targets::random_knot_problem(request.options))
    return core::Error{"target random-knot", *problem};
  const auto knot = random_targets::random_knot(request.options);
  if (!knot)
    return core::Error{"target random-knot",
                       "no draw of this seed keeps clear of itself; try another --seed"};
  return write_curves(request.output, {&knot->curve, 1});
}

std::string option_name(std::string_view parameter) {
  std::string name = "--" + std::string(parameter);
  std::ranges::replace(name, '_', '-');
  return name;
}

void add_output(CLI::App& command, std::string& output) {
  command.add_option(
      "-o,--output", output,
      "File to write, of the format of its ending: .obj, .csv, .txt, .json, .vect, .dxf "
      "[OBJ to standard output]");
}

void add_family(CLI::App& target, const curves::Family& family, Command& chosen) {
  const auto request = std::make_shared<FamilyRequest>();
  request->family = family;
  request->vertices = family.vertices;
  for (const auto& parameter : family.parameters) request->values.push_back(parameter.standard);

  CLI::App* command =
      target.add_subcommand(std::string(family.name), "Write " + std::string(family.meaning));
  for (std::size_t i = 0; i < family.parameters.size(); ++i) {
    const auto& parameter = family.parameters[i];
    command
        ->add_option(option_name(parameter.name), request->values[i],
                     std::string(parameter.meaning) + (parameter.integer ? "" : ", cm"))
        ->capture_default_str();
  }
  command->add_option("--vertices", request->vertices, "vertices of each rod")
      ->capture_default_str();
  add_output(*command, request->output);
  command->callback([&chosen, request] {
    chosen = [request](const Console&) { return write_family(*request); };
  });
}

void add_random_knot(CLI::App& target, Command& chosen) {
  const auto request = std::make_shared<KnotRequest>();
  random_targets::RandomKnotOptions& options = request->options;
  CLI::App* command = target.add_subcommand(
      "random-knot", "Write a closed rod at rest under random springs (figure 14)");
  command->add_option("--cables", options.cables, "springs that make it")->capture_default_str();
  command->add_option("--length", options.length, "of the rod, cm")->capture_default_str();
  command->add_option("--seed", options.seed, "another seed, another knot")->capture_default_str();
  command->add_option("--vertices", options.vertices, "vertices of the rod")->capture_default_str();
  add_output(*command, request->output);
  command->callback([&chosen, request] {
    chosen = [request](const Console&) { return write_random_knot(*request); };
  });
}

}  // namespace

void add_target(CLI::App& app, Command& chosen) {
  CLI::App* target = app.add_subcommand("target", "Write a target curve of a built-in family");
  target->footer(target_examples);
  target->require_subcommand(1);
  for (const curves::Family& family : curves::families()) add_family(*target, family, chosen);
  add_random_knot(*target, chosen);
}

}  // namespace tencer::app
