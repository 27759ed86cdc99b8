#include <catch2/catch.hpp>
#include <tencer/linalg/symmetric_assembler.hpp>

#include "random_symmetric.hpp"

using namespace tencer::linalg;
using tencer::linalg::test::full;

namespace {

Eigen::MatrixXd random_element(int k, std::mt19937& random) {
  std::normal_distribution<double> value;
  Eigen::MatrixXd element(k, k);
  for (int j = 0; j < k; ++j)
    for (int i = j; i < k; ++i) element(i, j) = element(j, i) = value(random);
  return element;
}

// What assembling means: sum of G^T K G, G the selection of an element's unknowns.
Eigen::MatrixXd dense_sum(int size, const std::vector<std::vector<int>>& elements,
                          const std::vector<Eigen::MatrixXd>& matrices) {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const int k = static_cast<int>(elements[e].size());
    Eigen::MatrixXd selection = Eigen::MatrixXd::Zero(k, size);
    for (int a = 0; a < k; ++a)
      if (elements[e][a] >= 0) selection(a, elements[e][a]) = 1.0;
    sum += selection.transpose() * matrices[e] * selection;
  }
  return sum;
}

}  // namespace

TEST_CASE("assembling equals the dense sum, with eliminated and repeated unknowns") {
  std::mt19937 random(7);
  const int size = 9;
  const std::vector<std::vector<int>> elements{
      {0, 1, 2, 3}, {3, 2, 7}, {-1, 4, 5}, {8, -1, -1, 0}, {6, 6, 1}, {5, 2, 5, 2}, {-1, -1}, {}};
  std::vector<Eigen::MatrixXd> matrices;
  for (const auto& element : elements)
    matrices.push_back(random_element(static_cast<int>(element.size()), random));

  const SymmetricAssembler assembler(size, elements);
  REQUIRE(assembler.elements() == static_cast<int>(elements.size()));
  SymmetricMatrix sum = assembler.pattern();
  for (int e = 0; e < assembler.elements(); ++e) assembler.add(e, matrices[e].data(), sum);
  CHECK((full(sum) - dense_sum(size, elements, matrices)).cwiseAbs().maxCoeff() < 1e-14);
}

TEST_CASE("the pattern holds every diagonal entry and the lower triangle only") {
  const std::vector<std::vector<int>> elements{{4, 0}, {-1, 2}};
  const SymmetricMatrix pattern = SymmetricAssembler(5, elements).pattern();
  REQUIRE(pattern.isCompressed());
  CHECK(pattern.nonZeros() == 6);  // 5 on the diagonal and (4, 0)
  for (int j = 0; j < 5; ++j) {
    CHECK(pattern.innerIndexPtr()[pattern.outerIndexPtr()[j]] == j);
    for (SymmetricMatrix::InnerIterator entry(pattern, j); entry; ++entry) {
      CHECK(entry.row() >= entry.col());
      CHECK(entry.value() == 0.0);
    }
  }
}

TEST_CASE("an index beyond the size is the caller's mistake") {
  const std::vector<std::vector<int>> elements{{0, 1}, {1, 3}};
  CHECK_THROWS_AS(SymmetricAssembler(3, elements), std::invalid_argument);
}

TEST_CASE("adding twice keeps the pattern and doubles the values") {
  std::mt19937 random(3);
  const std::vector<std::vector<int>> elements{{0, 2}, {1, 2}};
  const SymmetricAssembler assembler(3, elements);
  const Eigen::MatrixXd element = random_element(2, random);
  SymmetricMatrix once = assembler.pattern();
  assembler.add(1, element.data(), once);
  SymmetricMatrix twice = once;
  assembler.add(1, element.data(), twice);
  CHECK(twice.nonZeros() == assembler.pattern().nonZeros());
  CHECK(full(twice) == 2.0 * full(once));
}
