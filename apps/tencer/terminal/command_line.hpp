// What is wrong with a command line, in one line that says what would be right.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace tencer::app {

// Of an app that refused what it was to parse; ends with whose --help to read.
std::string parse_message(const CLI::App& app, const CLI::ParseError& error);

}  // namespace tencer::app
