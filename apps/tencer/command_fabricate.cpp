// tencer fabricate DESIGN: what a person at a bench needs to build a design.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <sstream>
#include <tencer/core/words.hpp>
#include <tencer/fabricate/names.hpp>
#include <tencer/io/check.hpp>
#include <tencer/model/units.hpp>

#include "command.hpp"
#include "fabricate/sheet.hpp"
#include "terminal/activity.hpp"

namespace tencer::app {
namespace {

constexpr const char* fabricate_examples = R"(Examples:
  tencer fabricate knot/design.json                         sheet.pdf, strips and tables in knot/sheet
  tencer fabricate knot/design.json -o bench --paper letter
  tencer fabricate knot/design.json --joint 30 --knot 80    overlap of a closed rod's ends; per knot
  tencer fabricate knot/design.json --stock 2m --coil 100m --price-rod 1.80 --price-cable 0.60

Lengths are in mm, or end in mm, cm or m. docs/build-it.md goes from a design to a tied knot.)";

struct FabricateRequest {
  std::filesystem::path input;
  std::filesystem::path output;
  std::string paper = "a4";
  SheetOptions options;
};

core::Expected<ExitCode> run_fabricate(const FabricateRequest& request, const Console& console) {
  const auto read = io::read_checked_design(request.input);
  if (!read) return read.error();
  SheetOptions options = request.options;
  options.paper = request.paper == "letter" ? letter : a4;
  Activity activity(console, "taking it apart in simulation, for an order of tying");
  const auto sheet = make_sheet(*read, options);
  activity.end();
  if (!sheet) return core::Error{request.input.string(), sheet.error().text()};
  const std::filesystem::path folder =
      request.output.empty() ? request.input.parent_path() / "sheet" : request.output;
  if (const auto error = write_sheet(folder, *sheet)) return *error;
  const auto cables = static_cast<int>(sheet->list.cables.size());
  std::ostringstream text;
  text << (folder / "sheet.pdf").string() << ": " << core::counted(sheet->solid.rods, "rod") << ", "
       << core::counted(cables, "cable") << ", cut with " << sheet->list.allowances.joint
       << " mm for a joint and " << sheet->list.allowances.knot << " mm for each knot\n";
  console.say(text.str());
  const std::string what = !sheet->check                    ? "is not checked"
                           : sheet->check->passed == false  ? "does not pass its check"
                           : !not_looked_at(*sheet).empty() ? "is checked in part only"
                                                            : "";
  if (!what.empty())
    console.log()(core::Level::warning, request.input.string() + ": the design " + what +
                                            ", which the sheet says (tencer check)");
  return ExitCode::ok;
}

// "300", "300mm", "30 cm", "0.3m": in mm.
std::optional<double> read_length(const std::string& text) {
  double length = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), length);
  if (error != std::errc() || !std::isfinite(length) || length < 0) return std::nullopt;
  std::string unit(end, text.data() + text.size());
  unit.erase(0, unit.find_first_not_of(' '));
  if (unit.empty()) return length;
  if (std::ranges::count(model::length_units(), unit) == 0) return std::nullopt;
  return length * model::metres(unit) / model::metres("mm");
}

// An option that is a length, given to `set` in mm.
void add_length(CLI::App& command, const std::string& option, bool zero,
                const std::function<void(double)>& set, const std::string& help) {
  command
      .add_option_function<std::string>(
          option, [set](const std::string& text) { set(*read_length(text)); }, help)
      ->check(CLI::Validator(
          [zero](std::string& text) {
            const auto length = read_length(text);
            if (length && (zero || *length > 0)) return std::string();
            return std::string("expected a length") + (zero ? "" : " above zero") +
                   " in mm, cm or m, found " + text;
          },
          "LENGTH"));
}

}  // namespace

void add_fabricate(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("fabricate", "Print what is needed to build a design");
  command->footer(fabricate_examples);
  const auto request = std::make_shared<FabricateRequest>();
  fabricate::Allowances& allowances = request->options.allowances;
  Offers& offers = request->options.offers;
  command->add_option("DESIGN", request->input, "Design (design.json), or a published model")
      ->required();
  command->add_option("-o,--output", request->output,
                      "Folder for the sheet [sheet, beside the design]");
  command->add_option("--paper", request->paper, "Of the printer")
      ->check(one_of({"a4", "letter"}))
      ->capture_default_str();
  add_length(
      *command, "--joint", true, [&allowances](double mm) { allowances.joint = mm; },
      "By how much the ends of a closed rod overlap [0: they meet, in a sleeve]");
  add_length(
      *command, "--knot", true, [&allowances](double mm) { allowances.knot = mm; },
      "Of cable, at either end, for going round the rod and the knot [" +
          fabricate::tenths(allowances.knot) + " mm]");
  add_length(
      *command, "--stock", false, [&offers](double mm) { offers.rods.stock = mm; },
      "Of a bar that rods are cut from");
  add_length(
      *command, "--coil", false, [&offers](double mm) { offers.cables.stock = mm; },
      "Of a coil that cables are cut from");
  command->add_option("--price-rod", offers.rods.price_per_metre, "Of a metre of rod")
      ->check(positive_number());
  command->add_option("--price-cable", offers.cables.price_per_metre, "Of a metre of cable")
      ->check(positive_number());
  command->callback([&chosen, request] {
    chosen = [request](const Console& console) { return run_fabricate(*request, console); };
  });
}

}  // namespace tencer::app
