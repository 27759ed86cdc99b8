#include "curves/join_ends.hpp"

#include <algorithm>
#include <map>

namespace tencer::io {

std::vector<Run> join_ends(std::span<const PieceEnds> pieces,
                           const std::function<void(int piece, int point)>& branch) {
  const int count = static_cast<int>(pieces.size());
  const auto closed = [&](int i) { return pieces[i].from == pieces[i].to; };
  std::map<int, std::vector<int>> at;  // point -> the open pieces that end there
  for (int i = 0; i < count; ++i) {
    if (closed(i)) continue;
    for (const int point : {pieces[i].from, pieces[i].to}) {
      at[point].push_back(i);
      if (at[point].size() > 2) branch(i, point);
    }
  }
  std::vector<bool> taken(pieces.size(), false);
  const auto begins = [&](const Run::Part& part) {
    return part.reversed ? pieces[part.piece].to : pieces[part.piece].from;
  };
  const auto ends = [&](const Run::Part& part) { return begins({part.piece, !part.reversed}); };
  // From its last part on, as far as others follow.
  const auto extend = [&](Run& run) {
    while (!run.closed) {
      const int end = ends(run.parts.back());
      const auto& here = at[end];
      const auto next = std::ranges::find_if(here, [&](int i) { return !taken[i]; });
      if (next == here.end()) return;
      taken[*next] = true;
      run.parts.push_back({*next, pieces[*next].from != end});
      run.closed = ends(run.parts.back()) == begins(run.parts.front());
    }
  };
  const auto turn_round = [](Run& run) {
    std::ranges::reverse(run.parts);
    for (Run::Part& part : run.parts) part.reversed = !part.reversed;
  };
  std::vector<Run> runs;
  for (int i = 0; i < count; ++i) {
    if (taken[i]) continue;
    taken[i] = true;
    Run run{{{i, false}}, closed(i)};
    extend(run);
    turn_round(run);
    extend(run);
    turn_round(run);
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace tencer::io
