#include <algorithm>
#include <numeric>
#include <tencer/core/error.hpp>
#include <tencer/linalg/symmetric_assembler.hpp>

namespace tencer::linalg {

SymmetricAssembler::SymmetricAssembler(int size, std::span<const std::vector<int>> elements) {
  std::vector<int> first_place(size + 1, 0);
  first_slot_.push_back(0);
  for (int e = 0; e < static_cast<int>(elements.size()); ++e) {
    const auto& element = elements[e];
    int pairs = 0;
    for (int b = 0; b < static_cast<int>(element.size()); ++b) {
      core::require(element[b] < size, "SymmetricAssembler: an index is not below the size");
      if (element[b] < 0) continue;
      ++first_place[element[b] + 1];
      for (int row : element) pairs += row >= element[b] ? 1 : 0;
    }
    first_slot_.push_back(first_slot_.back() + pairs);
  }

  // For every unknown, where it stands in the elements.
  struct Place {
    int element;
    int local;
  };
  std::partial_sum(first_place.begin(), first_place.end(), first_place.begin());
  std::vector<Place> all_places(first_place.back());
  std::vector<int> next_place(first_place.begin(), first_place.end() - 1);
  for (int e = 0; e < static_cast<int>(elements.size()); ++e)
    for (int b = 0; b < static_cast<int>(elements[e].size()); ++b)
      if (elements[e][b] >= 0) all_places[next_place[elements[e][b]]++] = {e, b};
  const auto places = [&](int unknown) {
    return std::span(all_places)
        .subspan(first_place[unknown], first_place[unknown + 1] - first_place[unknown]);
  };

  // Column by column: which rows its elements couple it with, then where their entries land.
  slots_.resize(first_slot_.back());
  std::vector<int> next_slot(first_slot_.begin(), first_slot_.end() - 1);
  std::vector<int> position(size, -1);
  std::vector<int> rows, all_rows, column_starts{0};
  for (int j = 0; j < size; ++j) {
    rows.assign(1, j);
    position[j] = 0;
    for (const Place& place : places(j))
      for (int row : elements[place.element])
        if (row > j && position[row] < 0) {
          position[row] = 0;
          rows.push_back(row);
        }
    std::ranges::sort(rows);
    for (int row : rows) {
      position[row] = static_cast<int>(all_rows.size());
      all_rows.push_back(row);
    }
    column_starts.push_back(static_cast<int>(all_rows.size()));
    for (const Place& place : places(j)) {
      const auto& element = elements[place.element];
      const int k = static_cast<int>(element.size());
      for (int a = 0; a < k; ++a)
        if (element[a] >= j)
          slots_[next_slot[place.element]++] = {a + place.local * k, position[element[a]]};
    }
    for (int row : rows) position[row] = -1;
  }
  const Eigen::VectorXd zeros = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(all_rows.size()));
  pattern_ = Eigen::Map<const SymmetricMatrix>(size, size, zeros.size(), column_starts.data(),
                                               all_rows.data(), zeros.data());
}

void SymmetricAssembler::add(int element, const double* element_matrix,
                             SymmetricMatrix& matrix) const {
  double* values = matrix.valuePtr();
  for (int s = first_slot_[element]; s < first_slot_[element + 1]; ++s)
    values[slots_[s].target] += element_matrix[slots_[s].source];
}

}  // namespace tencer::linalg
