// Curves that files hold in pieces: pieces that end where others do, put in a row.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace tencer::io {

// Where a piece begins and ends; ends with the same number are the same point.
struct PieceEnds {
  int from = 0;
  int to = 0;
};

struct Run {
  struct Part {
    int piece = 0;
    bool reversed = false;
  };
  std::vector<Part> parts;  // each begins where the one before ends
  bool closed = false;      // the last ends where the first begins
};

// The runs in the order of their first pieces, each in the direction of that piece. Where more than
// two ends meet, `branch` is called with a piece and the number of the point; it does not return.
std::vector<Run> join_ends(std::span<const PieceEnds> pieces,
                           const std::function<void(int piece, int point)>& branch);

}  // namespace tencer::io
