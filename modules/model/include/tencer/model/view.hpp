// From where a target is looked at, when only what is seen from there counts.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace tencer::model {

// A direction in the target's frame; the opposite one sees the same (the view is from far away,
// without perspective).
struct View {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // of any length but 0
  double weight = 1.0;                                   // > 0; counts against that of other views
};

// The square of a distance d as it is seen: d^T M d. Of one view that is the part of d across it,
// of several the weighted mean of the squares; of none all of d (M = 1). Positive semidefinite.
Eigen::Matrix3d seen_metric(const std::vector<View>& views);

// Takes a distance d to what is seen of it, as long: the symmetric root of that M.
Eigen::Matrix3d seeing(const std::vector<View>& views);

// The views of a target that is turned by `rotation`.
std::vector<View> turned(std::vector<View> views, const Eigen::Matrix3d& rotation);

// What is wrong with views, of several "views[1]: ..."; not set: nothing.
std::optional<std::string> view_problem(const std::vector<View>& views);

// "seen along (0, 0, 1)", "seen along (0, 0, 1) and (1, 0, 0)"; empty without views.
std::string seen_in_words(const std::vector<View>& views);

}  // namespace tencer::model
