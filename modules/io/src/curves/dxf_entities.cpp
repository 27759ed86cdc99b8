#include "curves/dxf_entities.hpp"

#include <algorithm>

#include "curves/finish_curve.hpp"
#include "text/bad_input.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

std::string_view trimmed(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(" \t") + 1 - first);
}

struct Group {
  int code = 0;
  std::string_view value;
  int line = 0;
};

// Two lines each: a number that says what follows, and the value.
std::vector<Group> groups(std::string_view text, const std::string& file) {
  const auto all = lines(text);
  std::vector<Group> result;
  for (std::size_t i = 0; i + 1 < all.size(); i += 2) {
    const auto code = to_integer(trimmed(all[i]));
    const int line = static_cast<int>(i) + 1;
    if (!code || *code < -5 || *code > 1071)
      fail(file + ":" + std::to_string(line), "expected the number of a DXF group, found " +
                                                  quoted(all[i].substr(0, 20)) +
                                                  "; save it as DXF in text (ASCII) form");
    result.push_back({static_cast<int>(*code), trimmed(all[i + 1]), line + 1});
    if (*code == 0 && result.back().value == "EOF") break;
  }
  return result;
}

// Each from BLOCK to ENDBLK.
std::map<std::string_view, DxfBlock> blocks_of(const std::vector<DxfEntity>& entities) {
  std::map<std::string_view, DxfBlock> blocks;
  DxfBlock* block = nullptr;
  for (const DxfEntity& entity : entities) {
    if (entity.name == "BLOCK")
      block = &(blocks[entity.text(2)] = {entity, {}});
    else if (entity.name == "ENDBLK")
      block = nullptr;
    else if (block != nullptr)
      block->entities.push_back(entity);
  }
  return blocks;
}

}  // namespace

bool DxfEntity::has(int code) const {
  return std::ranges::any_of(values, [&](const auto& value) { return value.first == code; });
}

double DxfEntity::number(int code, double standard) const {
  for (const auto& [found, text] : values)
    if (found == code) return coordinate(text, where);
  return standard;
}

int DxfEntity::flags(int code) const {
  const double value = number(code);
  return value >= 0 && value < 1e6 ? static_cast<int>(value) : 0;
}

std::string_view DxfEntity::text(int code) const {
  for (const auto& [found, value] : values)
    if (found == code) return value;
  return {};
}

std::vector<double> DxfEntity::numbers(int code) const {
  std::vector<double> result;
  for (const auto& [found, text] : values)
    if (found == code) result.push_back(coordinate(text, where));
  return result;
}

Eigen::Vector3d DxfEntity::point(int code) const {
  return {number(code), number(code + 10), number(code + 20)};
}

std::vector<Eigen::Vector3d> DxfEntity::points(int code) const {
  std::vector<Eigen::Vector3d> result;
  for (const auto& [found, text] : values) {
    if (found == code) result.emplace_back(coordinate(text, where), 0, 0);
    if (result.empty()) continue;
    if (found == code + 10) result.back().y() = coordinate(text, where);
    if (found == code + 20) result.back().z() = coordinate(text, where);
  }
  return result;
}

DxfContent dxf_content(std::string_view text, const std::string& file) {
  DxfContent content;
  std::vector<DxfEntity> of_blocks;
  std::string_view section;
  bool in_units = false;
  bool names_section = false;
  bool is_dxf = false;
  DxfEntity* entity = nullptr;
  for (const auto& [code, value, line] : groups(text, file)) {
    if (code == 0) {
      names_section = value == "SECTION";
      if (names_section || value == "ENDSEC") section = {};
      entity = nullptr;
      if (section == "ENTITIES" || section == "BLOCKS") {
        auto& list = section == "ENTITIES" ? content.entities : of_blocks;
        list.push_back(
            {std::string(value), file + ":" + std::to_string(line) + ": " + std::string(value)});
        entity = &list.back();
      }
    } else if (code == 2 && names_section) {
      section = value;
      is_dxf = true;
      names_section = false;
    } else if (code == 9) {
      in_units = section == "HEADER" && value == "$INSUNITS";
    } else if (code == 70 && in_units) {
      content.units = static_cast<int>(to_integer(value).value_or(0));
      in_units = false;
    } else if (entity) {
      entity->values.emplace_back(code, value);
    }
  }
  if (!is_dxf) fail(file, "holds no section of a DXF file");
  content.blocks = blocks_of(of_blocks);
  return content;
}

}  // namespace tencer::io
