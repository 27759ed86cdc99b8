// Sums small dense element matrices into a sparse symmetric matrix whose pattern is fixed once, so
// that assembling again neither searches nor allocates.
#pragma once

#include <Eigen/Sparse>
#include <span>
#include <vector>

namespace tencer::linalg {

// Column-major, lower triangle only; the upper one is implied.
using SymmetricMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

class SymmetricAssembler {
 public:
  // elements: for each element the global index, below size, of each of its local unknowns, -1 for
  // an unknown that is eliminated (pinned) and whose rows are skipped. An element may name an
  // unknown twice. Throws std::invalid_argument for an index that is not below size.
  SymmetricAssembler(int size, std::span<const std::vector<int>> elements);

  int elements() const { return static_cast<int>(first_slot_.size()) - 1; }

  // A matrix with the pattern and zero values; every diagonal entry is stored.
  const SymmetricMatrix& pattern() const { return pattern_; }

  // Adds the symmetric element matrix (k x k, k the length of the element's index list, column
  // major, both triangles filled) to `matrix`, a copy of pattern(). Called for every element of
  // every Hessian, so nothing is checked; threads need a matrix each.
  void add(int element, const double* element_matrix, SymmetricMatrix& matrix) const;

 private:
  struct Slot {
    int source;  // position in the element matrix
    int target;  // position in the sparse values
  };
  SymmetricMatrix pattern_;
  std::vector<int> first_slot_;
  std::vector<Slot> slots_;
};

}  // namespace tencer::linalg
