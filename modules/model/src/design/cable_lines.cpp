#include <tencer/model/cable_lines.hpp>
#include <tencer/model/state.hpp>

namespace tencer::model {

std::vector<geometry::Polyline> cable_lines(const Design& design) {
  const Eigen::Matrix3Xd ends = cable_ends(design.structure, design.pose);
  std::vector<geometry::Polyline> lines;
  for (Eigen::Index i = 0; i < ends.cols(); i += 2) lines.push_back({ends.middleCols<2>(i), false});
  return lines;
}

}  // namespace tencer::model
