#include <tencer/linalg/lowest_eigenpairs.hpp>
#include <tencer/linalg/symmetric_factor.hpp>

int main() {
  const std::vector<std::vector<int>> elements{{0, 1}, {1, 2}, {2}};
  const tencer::linalg::SymmetricAssembler assembler(3, elements);
  auto matrix = assembler.pattern();
  matrix.coeffRef(0, 0) = 1.0;
  matrix.coeffRef(1, 1) = 2.0;
  matrix.coeffRef(2, 2) = -3.0;
  tencer::linalg::SymmetricFactor factor;
  return factor.factorise(matrix) && factor.inertia().negative == 1 ? 0 : 1;
}
