// How near cables come to rods and to each other's marks: what must not touch in a structure that
// is built.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <tencer/model/rules.hpp>
#include <tencer/model/state.hpp>
#include <vector>

namespace tencer::model {

// How far each rod's surface is from its centre line at most.
std::vector<double> outer_radii(const Structure& structure);

// A place on a rod where a cable ends.
struct Mark {
  double s = 0.0;  // arc length at rest, on the rod
  int cable = 0;
  int end = 0;  // of the cable: 0 for a, 1 for b
};

// The marks of every rod, along it (those at one place in the order of their cables), wrapped on
// closed rods and clamped on open ones. along: the rods' arc lengths.
std::vector<std::vector<Mark>> marks_along(const std::vector<springs::Cable>& cables,
                                           const std::vector<geometry::ArcLength>& along);

// Two marks next to each other on a rod, the second `apart` further on; 0 for the same place.
struct MarkPair {
  Mark first{};
  Mark second{};
  int rod = 0;
  double apart = 0.0;
};

// Rod by rod, along each, on a closed one across its seam as well. along: the rods' arc lengths.
std::vector<MarkPair> neighbouring_marks(const std::vector<springs::Cable>& cables,
                                         const std::vector<geometry::ArcLength>& along);

// Where a cable passes a rod: where it is nearest to some stretch of the rod.
struct CablePass {
  int cable = 0;
  int rod = 0;
  int edge = 0;           // of the rod
  double t = 0.0;         // in [0, 1] along the edge
  double u = 0.0;         // in [0, 1] from the cable's end a to its end b
  double distance = 0.0;  // from the cable to the bend that the chain of vertices stands for
  Eigen::Vector3d away = Eigen::Vector3d::Zero();  // from rod to cable, of length 1
  // The cable's own end (0 for a, 1 for b) whose neighbourhood on the rod ends here; -1: none does.
  int beside_end = -1;
};

// The rods of a structure at a state, laid out so that those near a cable are found quickly. Refers
// to both.
class CablePasses {
 public:
  CablePasses(const Structure& structure, const State& state, const Gaps& gaps = {});

  // Where the cable passes within `times` the distance gaps.from_axis() of a rod: the nearest place
  // of each stretch that is so near; with the default, of each stretch between the cable's own
  // ends. number: what the passes call the cable.
  std::vector<CablePass> of(const springs::Cable& cable, int number = 0,
                            double times = std::numeric_limits<double>::infinity()) const;

  // Whether it keeps gaps.from_axis() of all rods.
  bool clear(const springs::Cable& cable) const { return of(cable, 0, 1.0).empty(); }

  // What a pass is nearer than that; <= 0: it is not.
  double missing(const CablePass& pass) const {
    return gaps_.from_axis(radii_[pass.rod]) - pass.distance;
  }

 private:
  // Edges of a rod, within a ball.
  struct Ball {
    int rod = 0;
    int first = 0;
    int end = 0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double radius = 0.0;
    double bulge = 0.0;  // how far a bend is beyond it at most
  };
  // A part of an edge, from t = from to t = to; what of the cable's own ends bounds it.
  struct Part {
    double from = 0.0;
    double to = 1.0;
    int from_end = -1;
    int to_end = -1;
  };

  void add_balls(int rod);
  Eigen::Vector3d vertex(int rod, int index) const;
  Eigen::Vector3d point(const springs::End& end) const;
  double own_arc(int rod, const springs::Cable& cable) const;
  std::vector<Part> parts_of(int rod, int edge, const springs::Cable& cable) const;

  const Structure& structure_;
  const State& state_;
  Gaps gaps_;
  std::vector<double> radii_;
  std::vector<geometry::ArcLength> along_;
  std::vector<Eigen::Matrix3Xd> bulges_;  // per rod, per edge: from the chord to the bend
  std::vector<Ball> balls_;
};

}  // namespace tencer::model
