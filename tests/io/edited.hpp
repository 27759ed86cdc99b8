#pragma once

#include <random>
#include <string>

// The text with so many of its characters replaced by others of it.
inline std::string edited(std::string text, int edits, std::mt19937& random) {
  const std::string before = text;
  for (int edit = 0; edit < edits; ++edit)
    text[random() % text.size()] = before[random() % before.size()];
  return text;
}
