#include "command.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <tencer/core/nearest.hpp>
#include <tencer/model/allowance.hpp>
#include <tencer/model/material.hpp>

namespace tencer::app {
namespace {

// With commas between them.
std::string material_names() {
  std::string names;
  for (const model::Material& material : model::materials())
    names += (names.empty() ? "" : ", ") + material.name;
  return names;
}

CLI::Validator known_material() {
  return {[](std::string& name) {
            return model::find_material(name)
                       ? std::string()
                       : "there is no '" + name + "'; use one of " + material_names();
          },
          "MATERIAL"};
}

}  // namespace

CLI::Validator positive_number() {
  return {[](std::string& text) {
            double value = 0;
            const bool fine =
                CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0;
            return fine ? std::string() : "expected a positive number, found " + text;
          },
          "POSITIVE"};
}

CLI::Validator not_negative_number() {
  return {[](std::string& text) {
            double value = 0;
            const bool fine =
                CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value >= 0;
            return fine ? std::string() : "expected a number that is not negative, found " + text;
          },
          "NOT NEGATIVE"};
}

CLI::Validator allowance() {
  return {[](std::string& text) {
            return model::read_allowance(text)
                       ? std::string()
                       : "expected a positive number in %, mm, cm or m, found " + text;
          },
          "ALLOWANCE"};
}

CLI::Validator positive_integer() {
  return {[](std::string& text) {
            int value = 0;
            const bool fine = CLI::detail::lexical_cast(text, value) && value > 0;
            return fine ? std::string() : "expected a positive whole number, found " + text;
          },
          "POSITIVE INTEGER"};
}

CLI::Validator one_of(std::vector<std::string> words) {
  std::string braces = "{";
  for (const std::string& word : words) braces += (word == words.front() ? "" : ",") + word;
  return {
      [choices = std::move(words)](std::string& text) {
        if (std::ranges::find(choices, text) != choices.end()) return std::string();
        const std::vector<std::string_view> known(choices.begin(), choices.end());
        const std::string_view meant = core::nearest(text, known);
        std::string all;
        for (const std::string& choice : choices) all += (all.empty() ? "" : ", ") + choice;
        return "there is no '" + text + "'; " +
               (meant.empty() ? "use one of " + all : "did you mean " + std::string(meant) + "?");
      },
      braces + "}"};
}

void add_force(CLI::App& command, bool& force) {
  command.add_flag("--force", force, "Replace the design of something else in that folder");
}

CLI::Option* add_material(CLI::App& command, std::string& material) {
  return command
      .add_option("--material", material,
                  "What rods are made of that say nothing of it: " + material_names())
      ->check(known_material())
      ->capture_default_str();
}

}  // namespace tencer::app
