// Adds up rods to the units in which they are solved: the total length, the largest EI over it, and
// the mean of all vertices as origin.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <tencer/pipeline/prepare.hpp>

namespace tencer::pipeline {

class UnitsSum {
 public:
  void add(double length, double bending, const Eigen::Matrix3Xd& points) {
    length_ += length;
    bending_ = std::max(bending_, bending);
    sum_ += points.rowwise().sum();
    vertices_ += points.cols();
  }

  Units units() const {
    return {.scale = {.length = length_, .energy = bending_ / length_},
            .origin = sum_ / static_cast<double>(vertices_)};
  }

 private:
  double length_ = 0.0;
  double bending_ = 0.0;
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
  Eigen::Index vertices_ = 0;
};

}  // namespace tencer::pipeline
