// tencer target FAMILY: writes target curves of the built-in families.
#include <algorithm>
#include <memory>
#include <tencer/geometry/families.hpp>
#include <tencer/io/curve.hpp>

#include "command.hpp"

namespace tencer::app {
namespace {

constexpr const char* examples = R"(Examples:
  tencer target --list
  tencer target trefoil-hypotrochoid -o trefoil.obj
  tencer target torus-knot --p 5 --q 3 --vertices 201 -o knot.obj)";

struct FamilyRequest {
  geometry::Family family;
  std::vector<double> values;  // one for each of the family's parameters
  int vertices = 0;
  std::string output;
};

core::Expected<ExitCode> write_family(const FamilyRequest& request) {
  if (const auto problem =
          geometry::family_problem(request.family, request.values, request.vertices))
    return core::Error{"target " + std::string(request.family.name), *problem};
  const auto curves = geometry::family_curves(request.family, request.values, request.vertices);
  if (const auto error = io::write_obj(request.output, curves)) return *error;
  return ExitCode::ok;
}

std::string option_name(std::string_view parameter) {
  std::string name = "--" + std::string(parameter);
  std::ranges::replace(name, '_', '-');
  return name;
}

void add_family(CLI::App& target, const geometry::Family& family, Command& chosen) {
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
  command->add_option("-o,--output", request->output, "OBJ file to write")->required();
  command->callback([&chosen, request] {
    chosen = [request](const core::Log&) { return write_family(*request); };
  });
}

}  // namespace

void add_target(CLI::App& app, Command& chosen) {
  CLI::App* target = app.add_subcommand("target", "Write a target curve of a built-in family");
  target->footer(examples);
  target->require_subcommand(1);
  for (const geometry::Family& family : geometry::families()) add_family(*target, family, chosen);
}

}  // namespace tencer::app
