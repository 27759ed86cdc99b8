// A design: a structure with the pose in which it stands, and what is known of it, as plain data in
// the user's units.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <tencer/geometry/polyline.hpp>
#include <tencer/model/at_least.hpp>
#include <tencer/model/certificate.hpp>
#include <tencer/model/check.hpp>
#include <tencer/model/goal.hpp>
#include <tencer/model/stage_row.hpp>
#include <tencer/model/strain.hpp>
#include <tencer/model/structure.hpp>
#include <tencer/model/view.hpp>
#include <vector>

namespace tencer::model {

// Distance of the pose to the target in percent of the target's bounding-box diagonal.
struct DesignError {
  double max_percent = 0.0;
  double rms_percent = 0.0;
};

// A cable as it is built: it can neither stretch nor push.
struct BuiltCable {
  double length = 0.0;
  double tension = 0.0;
};

enum class DesignStatus { complete, tolerance_not_reached, interrupted };

struct Design {
  std::string name{};
  DesignStatus status = DesignStatus::complete;
  std::string length_unit = "cm";
  std::string force_unit = "N";
  // Its cables as springs; those of stiffness 0 are known as built only.
  Structure structure{};
  std::vector<BuiltCable> built{};         // one a cable
  std::vector<Eigen::Matrix3Xd> target{};  // per rod, 3 x n
  std::vector<View> views{};               // from where its error is seen; none: in space
  std::vector<Eigen::Matrix3Xd> pose{};    // per rod, 3 x n
  // Per rod, 3 x edges: where the section's first axis points on every edge, as far as it is
  // perpendicular to the edge. No columns: not known, or of no consequence.
  std::vector<Eigen::Matrix3Xd> target_directors{};
  std::vector<Eigen::Matrix3Xd> pose_directors{};
  // Per rod, at the pose; none in a design that nobody solved yet.
  std::vector<std::optional<BendingStrain>> strains{};
  std::optional<DesignError> error = std::nullopt;  // not set in a design that nobody solved yet
  std::optional<Certificate> certificate = std::nullopt;  // likewise
  std::optional<Check> check = std::nullopt;  // what was looked at of being built; not read back
  std::optional<AtLeast> at_least = std::nullopt;  // not set: nobody asked
  std::vector<StageRow> trace{};                   // error against run time
  std::optional<Goal> goal = std::nullopt;         // what was asked for; not in design files

  bool complete() const { return status == DesignStatus::complete; }

  // One line: whether it is complete, how many cables, how close, whether it stands.
  std::string brief_report() const;
  // Several lines: its findings, and the stages with their times.
  std::string full_report() const;
};

// Why the design is not what was asked for, a clause each: "it does not stand"; none: it is. What
// its check finds counts.
std::vector<std::string> shortfalls(const Design& design);

// The cables, the error and the certificate in words, a line each.
std::string summary(const Design& design);

// For the words of its check.
CheckTerms terms_of(const Design& design);

// What was asked for, whether the design is that, and if not why, and its summary.
std::string findings(const Design& design);

// What a goal judges of a design that has an error.
Score score_of(const Design& design);

// How many of its cables end at anchors.
int external_cables(const Design& design);

// The curve that a rod's pose is.
geometry::Polyline pose_curve(const Design& design, std::size_t rod);

// The structure with cables that are as long as they are built: their rest length.
Structure as_built(const Design& design);

// The structure's cables as they are built where it stands in `pose` with them as springs: as long
// as there, and pulling as there.
std::vector<BuiltCable> built_in_pose(const Structure& structure,
                                      const std::vector<Eigen::Matrix3Xd>& pose);

}  // namespace tencer::model
