// A DXF file as the entities that it draws, each a list of numbered values.
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tencer::io {

struct DxfEntity {
  std::string name{};   // "LINE"
  std::string where{};  // in the file
  std::vector<std::pair<int, std::string_view>> values{};

  // The first number with this code, else `standard`; throws BadInput when it is none.
  double number(int code, double standard = 0.0) const;
  int flags(int code) const;
  std::string_view text(int code) const;  // the first one's, or ""
  std::vector<double> numbers(int code) const;
  bool has(int code) const;
  // x, y and z: `code`, code + 10, code + 20.
  Eigen::Vector3d point(int code) const;
  // One for each value with this code, of the x, y and z that follow it.
  std::vector<Eigen::Vector3d> points(int code) const;
};

// What entities INSERT draw.
struct DxfBlock {
  DxfEntity head;  // with its base point, 10
  std::vector<DxfEntity> entities;
};

struct DxfContent {
  std::vector<DxfEntity> entities;  // of the section ENTITIES
  std::map<std::string_view, DxfBlock> blocks;
  int units = 0;  // $INSUNITS; 0: none
};

// Throws BadInput. The text must outlive the content.
DxfContent dxf_content(std::string_view text, const std::string& file);

}  // namespace tencer::io
