// What checking a design finds: can it be built, and does it do then what it should? Plain data;
// lengths and forces in the design's units. A section that is not set was not found out.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tencer::model {

struct Stands {
  bool rests = false;    // false: no rest was found, and what follows is of the last try
  double moved = 0.0;    // a vertex, from the file's pose to where it comes to rest: a length
  double allowed = 0.0;  // motion at which that is another pose
  double residual = 0.0;
  double smallest_eigenvalue = 0.0;  // in eigenvalue_unit (certificate.hpp)
  int slack_cables = 0;
  bool certified = false;                  // forces balance, no cable is slack, every motion costs
  std::vector<double> hertz{};             // the lowest modes, ascending
  std::vector<std::string> free_groups{};  // what moves at no cost, in words
};

// Cables added for what moves at no cost, the last of the design.
struct Repair {
  int cables = 0;  // 0 and no problem: nothing moves at no cost
  int first_cable = 0;
  double least_tension = 0.0;  // of these cables: forces
  double most_tension = 0.0;
  double moved = 0.0;     // a vertex, from the pose without them: a length
  std::string problem{};  // why there are none, in words
};

// What errors of the cables do: of their lengths and of where they are tied along the rods, each
// independent and uniform up to the largest.
struct Forgives {
  double length_error = 0.0;
  double attachment_error = 0.0;
  double max_deviation = 0.0;  // allowed to 95 % of the structures built so
  // Largest distance of a vertex from the pose, to first order.
  int draws = 0;
  double expected = 0.0;
  double percentile_95 = 0.0;
  double worst = 0.0;
  int decisive_cable = -1;  // the one whose own errors move a vertex most; -1: none does
  double decisive = 0.0;    // root mean square of how far
  int first_slack = -1;     // the cable that errors let go slack first; -1: none
  double slack_at = 0.0;    // by this many times the errors, all at their worst
  // Some of the draws let settle, along the path of poses from no errors to theirs.
  int settled = 0;
  int fallen = 0;              // left the path for another pose
  double settled_worst = 0.0;  // largest deviation of those that did not
  // By so many times the errors the first of them falls; not set: none does up to falls_up_to.
  std::optional<double> falls_at = std::nullopt;
  double falls_up_to = 0.0;  // 0: their paths cannot be followed
};

// Pushes out of the pose along its softest motions, smooth and rough, and letting go.
struct Pushes {
  double size = 0.0;    // how far the vertex moves that moves most: a length
  int tried = 0;        // half of them smooth, half rough
  int back = 0;         // came to rest in the pose again
  int lost = 0;         // were not found to come to rest
  int strands_met = 0;  // of those back: strands may have passed through each other
};
// A stable pose beside the design's.
struct OtherPose {
  double distance = 0.0;  // largest distance of a vertex: a length
  double energy = 0.0;    // of rods and loads, less that of the design's pose: force times length
  int times = 0;          // pushes that ended there
};
struct ComesBack {
  std::vector<Pushes> pushes{};
  std::vector<OtherPose> others{};
};

// Strain and tension against what rods and cables bear.
struct Holds {
  double strain = 0.0;  // largest bending strain of a rod, a fraction; of the rod at arc length s
  int rod = -1;         // -1: no rod's section has a shape
  double s = 0.0;
  std::string material{};
  double strain_limit = 0.0;  // of the material, held for long
  double tension = 0.0;       // the largest, a force
  int cable = -1;             // -1: there are none
  double breaking_load = 0.0;
};

// How far its own weight moves a structure: the vertex that moves most, a length.
struct Sag {
  struct Support {
    int rod = 0;
    int vertex = 0;
    double s = 0.0;  // the vertex's arc length
  };
  double deviation = 0.0;
  std::vector<Support> at{};  // where it hangs, or stands on; none: its own supports hold it
  bool settled = false;       // where it comes to rest; false: to first order
  bool falls = false;         // to another pose, so far away
};
struct OwnWeight {
  bool included = false;                   // it is among the design's loads, and the pose has it
  bool held = false;                       // `hung` is as supports hold it
  std::optional<Sag> hung = std::nullopt;  // from its best place; not set: not known, or it swings
  std::optional<Sag> standing = std::nullopt;  // on three vertices; not set: it does not
};

// The least distance of its kind, and where, in words. Lengths; of rods between their surfaces, so
// that what is negative goes through.
struct LeastDistance {
  double distance = 0.0;
  std::string where{};
};
// Not set: there is no such pair.
struct Clear {
  std::optional<LeastDistance> rods = std::nullopt;       // between strands
  std::optional<LeastDistance> cable_rod = std::nullopt;  // away from the cable's own ends
  std::optional<LeastDistance> cables = std::nullopt;     // that do not meet
  std::optional<LeastDistance> marks = std::nullopt;      // of two cables, along a rod
};

// How the pose changes with the number of vertices: every edge divided into 2, 4, 8.
struct Refinement {
  int times = 1;
  double moved = 0.0;   // largest motion of a vertex since half as many edges: a length
  bool settles = true;  // false: no pose was found
};
struct Converged {
  std::vector<Refinement> refinements{};
  double allowed = 0.0;   // motion at which the pose counts as converged
  double distance = 0.0;  // about how far the file's pose is from that of ever finer rods
  bool converged = false;
};

// What a check's words need to know of its design.
struct CheckTerms {
  std::string length_unit{};  // that its numbers are in, see units.hpp
  std::string force_unit{};
  std::size_t rods = 0;
};

struct Check {
  std::optional<Repair> repair = std::nullopt;  // what follows holds with it
  std::optional<Stands> stands = std::nullopt;
  std::optional<Forgives> forgives = std::nullopt;
  std::optional<ComesBack> comes_back = std::nullopt;
  std::optional<Holds> holds = std::nullopt;
  std::optional<OwnWeight> weight = std::nullopt;
  std::optional<Clear> clear = std::nullopt;
  std::optional<Converged> converged = std::nullopt;
};

// What fails, a clause each that starts with the section: "forgives: ..."; none: nothing does.
std::vector<std::string> shortfalls(const Check& check, const CheckTerms& terms);

// A section in a line: what it says, lengths in mm and forces in N, and whether it fails.
struct CheckLine {
  std::string section{};  // "forgives"
  std::string text{};
  bool fails = false;
};
std::vector<CheckLine> sections(const Check& check, const CheckTerms& terms);

// The sections that a whole check has and these lines lack: what they say nothing of.
std::vector<std::string> not_looked_at(const std::vector<CheckLine>& lines);

// The same, as lines of a report: "forgives: ...".
std::string lines(const Check& check, const CheckTerms& terms);

// lines(), and "fails: ..." for each shortfall.
std::string report(const Check& check, const CheckTerms& terms);

}  // namespace tencer::model
