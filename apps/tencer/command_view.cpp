// tencer view DESIGN...: one page to look at designs in a browser.
#include <spawn.h>

#include <array>
#include <cstring>
#include <deque>
#include <iostream>
#include <memory>
#include <tencer/io/design.hpp>
#include <tencer/io/file.hpp>
#include <vector>

#include "command.hpp"
#include "view_page.hpp"

namespace tencer::app {
namespace {

constexpr const char* view_examples = R"(Examples:
  tencer view knot/design.json --open                 look at it in the browser
  tencer view before/design.json after/design.json -o both.html
                                                      two designs, one laid over the other
  tencer view knot/cables-*/design.json -o knot.html  a trade-off as a plot, a design a point

The page needs no network. It starts with the first design.)";

struct ViewRequest {
  std::vector<std::filesystem::path> inputs;
  std::filesystem::path output;
  bool open = false;
};

// Leaves it to the desktop which program that is, and does not wait for it.
std::optional<core::Error> open_in_browser(const std::filesystem::path& page) {
  std::string program = "xdg-open";
  std::string path = std::filesystem::absolute(page).string();
  std::array<char*, 3> arguments{program.data(), path.data(), nullptr};
  pid_t child = 0;
  const int failed =
      posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments.data(), environ);
  if (failed == 0) return std::nullopt;
  return core::Error{"--open", "xdg-open cannot be run (" + std::string(std::strerror(failed)) +
                                   "); open " + page.string() + " in a browser"};
}

std::filesystem::path page_of(const ViewRequest& request) {
  if (!request.output.empty()) return request.output;
  if (request.inputs.size() > 1 || request.inputs[0] == "-") return "designs.html";
  return request.inputs[0].parent_path() / "view.html";
}

core::Expected<ExitCode> run_view(const ViewRequest& request, const Console& console) {
  std::deque<model::Design> designs;  // stay where they are
  std::vector<PageDesign> shown;
  for (const auto& input : request.inputs) {
    auto design = io::read_design(input);
    if (!design) return design.error();
    if (design->pose.empty())
      return core::Error{input.string(), "has no rods; there is nothing to be seen"};
    std::string text;  // what comes from a pipe is gone
    if (std::filesystem::is_regular_file(input)) {
      auto read = io::read_file(input);
      if (!read) return read.error();
      text = std::move(*read);
    }
    designs.push_back(std::move(*design));
    shown.push_back({.design = designs.back(), .file_text = std::move(text)});
  }
  const std::filesystem::path page = page_of(request);
  if (auto error = io::write_file(page, view_page(shown))) return *error;
  console.say("see " + page.string() + '\n');
  if (request.open)
    if (auto error = open_in_browser(page)) {
      std::cerr << "tencer: " << error->text() << '\n';
      return ExitCode::unexpected;
    }
  return ExitCode::ok;
}

}  // namespace

void add_view(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("view", "Write a page to look at designs in a browser");
  command->footer(view_examples);
  const auto request = std::make_shared<ViewRequest>();
  command->add_option("DESIGN", request->inputs, "Designs (design.json), or published models")
      ->required();
  command->add_option("-o,--output", request->output,
                      "The page [view.html beside the design; of several, designs.html here]");
  command->add_flag("--open", request->open, "Open it in the browser");
  command->callback([&chosen, request] {
    chosen = [request](const Console& console) { return run_view(*request, console); };
  });
}

}  // namespace tencer::app
