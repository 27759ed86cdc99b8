#include "text/length_unit.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "text/text.hpp"

namespace tencer::io {
namespace {

struct Spelling {
  std::string_view word;
  std::string_view unit;
};
constexpr std::array spellings{Spelling{"mm", "mm"},
                               Spelling{"millimetre", "mm"},
                               Spelling{"millimeter", "mm"},
                               Spelling{"cm", "cm"},
                               Spelling{"centimetre", "cm"},
                               Spelling{"centimeter", "cm"},
                               Spelling{"m", "m"},
                               Spelling{"metre", "m"},
                               Spelling{"meter", "m"},
                               Spelling{"in", "in"},
                               Spelling{"inch", "in"},
                               Spelling{"ft", "ft"},
                               Spelling{"millimetres", "mm"},
                               Spelling{"millimeters", "mm"},
                               Spelling{"centimetres", "cm"},
                               Spelling{"centimeters", "cm"},
                               Spelling{"metres", "m"},
                               Spelling{"meters", "m"},
                               Spelling{"inches", "in"},
                               Spelling{"foot", "ft"},
                               Spelling{"feet", "ft"}};

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

// In one field of a header; `bare`: without brackets a unit may follow the name of an axis.
std::optional<std::string_view> unit_in_field(std::string_view field, bool bare) {
  constexpr std::array<std::string_view, 7> names{"x",     "y",      "z",      "unit",
                                                  "units", "length", "lengths"};
  const bool bracketed = field.find_first_of("([_/") != std::string_view::npos;
  std::string text = lower(field);
  std::ranges::replace_if(
      text,
      [](char c) {
        return std::string_view("()[]{},;:=\"'#%/_").find(c) != std::string_view::npos;
      },
      ' ');
  const std::vector<std::string_view> parts = words(text);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (std::ranges::find(names, parts[i - 1]) == names.end()) continue;
    if (parts[i - 1].size() == 1 && !bracketed && !bare) continue;  // the column after z
    if (const auto unit = unit_meant(parts[i])) return unit;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string_view> unit_meant(std::string_view word) {
  const auto* found = std::ranges::find(spellings, lower(word), &Spelling::word);
  if (found == spellings.end()) return std::nullopt;
  return found->unit;
}

std::optional<std::string_view> unit_in(std::string_view line) {
  constexpr std::string_view separators = ",;\t";
  const bool bare = line.find_first_of(separators) != std::string_view::npos;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find_first_of(separators), line.size());
    if (const auto unit = unit_in_field(line.substr(0, end), bare)) return unit;
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return std::nullopt;
}

}  // namespace tencer::io
