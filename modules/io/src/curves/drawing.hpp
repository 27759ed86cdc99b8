// Drawings: strokes of smooth pieces, as SVG and DXF have them.
#pragma once

#include <string>
#include <tencer/io/curve.hpp>
#include <vector>

#include "curves/pieces.hpp"

namespace tencer::io {

struct Stroke {
  std::vector<Piece> pieces{};  // each begins where the one before ends
  bool closed = false;          // the last ends where the first begins
  std::string where{};          // in the file
};

// Adds a curve for each stroke to the file; open strokes whose ends meet, within 1e-4 of the
// drawing's size, are joined first. Throws BadInput: where three ends meet, and as finish_curve.
void add_strokes(const std::vector<Stroke>& strokes, CurveFile& file);

}  // namespace tencer::io
