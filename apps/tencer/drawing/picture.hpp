// Pictures of a design as one would print them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/model/design.hpp>

#include "drawing/picture_options.hpp"

namespace tencer::app {

enum class PictureFormat { svg, pdf, png };

// By the ending of the name, in capitals or not; not set: it is none of them.
std::optional<PictureFormat> picture_format(const std::filesystem::path& path);

// Why there is no picture of this name: its ending is none of them.
std::optional<core::Error> picture_problem(const std::filesystem::path& path);

// Rods as smooth bands that leave a gap where others pass over them, cables as thin lines with
// numbers at the ends of leaders, anchors as squares; a bar for the scale; on white paper. The
// bytes of the file; PNG has 300 dots an inch. Requires at least one rod and a finite pose.
std::string picture(const model::Design& design, PictureFormat format,
                    const PictureOptions& options = {});

// The same as SVG for a page: as an element of it that follows the reader's light or dark scheme.
std::string picture_svg(const model::Design& design);

}  // namespace tencer::app
