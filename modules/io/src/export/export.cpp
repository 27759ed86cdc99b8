#include <tencer/core/error.hpp>
#include <tencer/io/export.hpp>

#include "export/writers.hpp"
#include "text/extension.hpp"

namespace tencer::io {

std::optional<ExportFormat> export_format(const std::filesystem::path& path) {
  const std::string ending = lower_extension(path);
  if (ending == ".obj") return ExportFormat::obj;
  if (ending == ".vtp") return ExportFormat::vtp;
  if (ending == ".gltf") return ExportFormat::gltf;
  if (ending == ".glb") return ExportFormat::glb;
  if (ending == ".dxf") return ExportFormat::dxf;
  if (ending == ".csv") return ExportFormat::csv;
  return std::nullopt;
}

std::string_view export_endings() { return ".obj, .vtp, .gltf, .glb, .dxf, .csv"; }

std::string_view export_unit(const model::Design& design, ExportFormat format) {
  const bool in_metres = format == ExportFormat::gltf || format == ExportFormat::glb;
  return in_metres ? std::string_view("m") : design.length_unit;
}

std::string export_text(const model::Design& design, ExportFormat format) {
  for (const Eigen::Matrix3Xd& pose : design.pose)
    core::require(pose.allFinite(), "export_text: needs a finite pose");
  switch (format) {
    case ExportFormat::obj:
      return obj_parts(design);
    case ExportFormat::vtp:
      return vtp_text(design);
    case ExportFormat::gltf:
      return gltf_text(design);
    case ExportFormat::glb:
      return glb_bytes(design);
    case ExportFormat::dxf:
      return dxf_parts(design);
    case ExportFormat::csv:
      return csv_table(design);
  }
  throw std::invalid_argument("export_text: there is no such format");
}

}  // namespace tencer::io
