// The same problem wherever it lies, however it is turned, and from whichever vertex its rods are
// counted: so that a search finds the same cables for the same shape.
#pragma once

#include <Eigen/Core>
#include <tencer/ground_structure/problem.hpp>
#include <tencer/model/stage_row.hpp>
#include <vector>

namespace tencer::elimination {

// A rod counted anew: from one of its vertices, and perhaps the other way. Open rods begin at an
// end.
struct Way {
  int start = 0;
  bool reversed = false;
};

class Canonical {
 public:
  // Rods are counted from where the shape is widest, and space is turned with the first of them.
  // The problem stays as it is, when it has a symmetry or a rod whose sides are not alike; it is
  // not turned when pins hold single coordinates, and only about z when it is planar.
  explicit Canonical(const ground_structure::Problem& problem);

  const ground_structure::Problem& problem() const { return problem_; }

  // A network of the rods that were given as one of problem().
  network::Network counted(network::Network network) const;

  // A network of problem() as one of the problem that was given, whose structure without cables is
  // `bare`.
  network::Network restored(const network::Network& network, const model::Structure& bare) const;
  void restore(model::Snapshot& snapshot) const;

 private:
  ground_structure::Problem problem_;
  std::vector<Way> ways_{};  // none: as it was given
  Eigen::Matrix3d turn_ = Eigen::Matrix3d::Identity();
};

}  // namespace tencer::elimination
