// tencer export DESIGN -o FILE: a design for other programs.
#include "command_export.hpp"

#include <memory>
#include <tencer/io/design.hpp>
#include <tencer/io/export.hpp>
#include <tencer/io/file.hpp>
#include <vector>

namespace tencer::app {
namespace {

constexpr const char* export_examples = R"(Examples:
  tencer export knot/design.json -o knot.obj     lines, an object a rod and a cable (Rhino, Blender)
  tencer export knot/design.json -o knot.glb     tubes, in metres
  tencer export knot/design.json -o knot.vtp     with curvature, strain, tension, deviation (ParaView)
  tencer export knot/design.json -o knot.dxf -o knot.csv

docs/exports.md says what each file holds.)";

struct ExportRequest {
  std::filesystem::path input;
  std::vector<std::filesystem::path> outputs;
};

core::Expected<ExitCode> run_export(const ExportRequest& request, const Console& console) {
  for (const auto& output : request.outputs)
    if (!io::export_format(output))
      return core::Error{output.string(),
                         "there is no format for this ending; let the name end with one of " +
                             std::string(io::export_endings()) + "; tencer picture draws .svg"};
  const auto design = io::read_design(request.input);
  if (!design) return design.error();
  for (const auto& output : request.outputs) {
    const io::ExportFormat format = *io::export_format(output);
    if (const auto error = io::write_file(output, io::export_text(*design, format))) return *error;
    console.say(output.string() + ": lengths in " + std::string(io::export_unit(*design, format)) +
                '\n');
  }
  return ExitCode::ok;
}

}  // namespace

void add_export(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("export", "Write a design for other programs");
  command->footer(export_examples);
  const auto request = std::make_shared<ExportRequest>();
  command->add_option("DESIGN", request->input, "Design (design.json), or a published model")
      ->required();
  command
      ->add_option("-o,--output", request->outputs,
                   "File to write, of the format of its ending: " +
                       std::string(io::export_endings()) + "; may be given several times")
      ->required()
      ->allow_extra_args(false);
  command->callback([&chosen, request] {
    chosen = [request](const Console& console) { return run_export(*request, console); };
  });
}

}  // namespace tencer::app
