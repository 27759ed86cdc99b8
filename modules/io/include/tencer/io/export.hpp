// Designs for other programs; docs/exports.md says what each file holds and which programs take it.
// They are written, not read back: design.json is what keeps a design.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <tencer/model/design.hpp>

namespace tencer::io {

enum class ExportFormat { obj, vtp, gltf, glb, dxf, csv };

// By the ending of the name, in capitals or not; not set: it is none of them.
std::optional<ExportFormat> export_format(const std::filesystem::path& path);

// ".obj, .vtp, .gltf, .glb, .dxf, .csv"
std::string_view export_endings();

// The unit of the file's lengths.
std::string_view export_unit(const model::Design& design, ExportFormat format);

// The bytes of the file: the pose of the rods, the cables and the anchors, by their names. Lengths
// and forces are in the design's units, which the file says as far as its format has a place for
// it; those of glTF are in metres, with y up, as it prescribes. Requires a finite pose, and rods
// whose neighbouring vertices differ.
std::string export_text(const model::Design& design, ExportFormat format);

}  // namespace tencer::io
