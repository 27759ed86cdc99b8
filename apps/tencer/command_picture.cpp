// tencer picture DESIGN -o FILE: drawings of a design, for papers and documents.
#include <memory>
#include <tencer/io/design.hpp>
#include <tencer/io/file.hpp>

#include "command.hpp"
#include "drawing/picture.hpp"

namespace tencer::app {
namespace {

constexpr const char* picture_examples = R"(Examples:
  tencer picture knot/design.json -o knot.pdf
  tencer picture knot/design.json -o knot.png --view oblique,front,side,top
  tencer picture knot/design.json -o knot.svg --caption "Figure 1: a trefoil" --no-numbers
  tencer picture knot/design.json -o knot.pdf -o knot.png

docs/pictures.md says what is drawn, and how.)";

struct PictureRequest {
  std::filesystem::path input;
  std::vector<std::filesystem::path> outputs;
  std::vector<std::string> views;
  std::string caption;
  bool no_numbers = false;
};

core::Expected<ExitCode> run_picture(const PictureRequest& request, const Console& console) {
  for (const auto& output : request.outputs)
    if (const auto error = picture_problem(output)) return *error;
  PictureOptions options{.caption = request.caption, .numbers = !request.no_numbers};
  for (const std::string& view : request.views) options.views.push_back(*view_named(view));
  const auto design = io::read_design(request.input);
  if (!design) return design.error();
  if (design->pose.empty())
    return core::Error{request.input.string(), "has no rods; there is nothing to be seen"};
  for (const auto& output : request.outputs) {
    const std::string drawn = picture(*design, *picture_format(output), options);
    if (const auto error = io::write_file(output, drawn)) return *error;
    console.say("see " + output.string() + '\n');
  }
  return ExitCode::ok;
}

}  // namespace

void add_picture(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("picture", "Draw a design for print");
  command->footer(picture_examples);
  const auto request = std::make_shared<PictureRequest>();
  command->add_option("DESIGN", request->input, "Design (design.json), or a published model")
      ->required();
  command
      ->add_option("-o,--output", request->outputs,
                   "File to draw, .svg, .pdf or .png; may be given several times")
      ->required()
      ->allow_extra_args(false);
  command
      ->add_option("--view", request->views,
                   "The side, or several with commas between them [oblique; front of what is flat]")
      ->delimiter(',')
      ->check(one_of(view_names()));
  command->add_option("--caption", request->caption, "Words below the drawing");
  command->add_flag("--no-numbers", request->no_numbers, "No names of rods and cables");
  command->callback([&chosen, request] {
    chosen = [request](const Console& console) { return run_picture(*request, console); };
  });
}

}  // namespace tencer::app
