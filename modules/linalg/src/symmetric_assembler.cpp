#include <algorithm>
#include <tencer/linalg/symmetric_assembler.hpp>

namespace tencer::linalg {

SymmetricAssembler::SymmetricAssembler(int size, std::span<const std::vector<int>> elements) {
  std::vector<std::vector<int>> rows_of_column(size);
  for (int i = 0; i < size; ++i) rows_of_column[i].push_back(i);
  for (const auto& element : elements)
    for (int column : element)
      for (int row : element)
        if (column >= 0 && row >= column) rows_of_column[column].push_back(row);

  pattern_.resize(size, size);
  std::vector<int> counts(size);
  for (int j = 0; j < size; ++j) {
    auto& rows = rows_of_column[j];
    std::ranges::sort(rows);
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    counts[j] = static_cast<int>(rows.size());
  }
  pattern_.reserve(counts);
  for (int j = 0; j < size; ++j)
    for (int i : rows_of_column[j]) pattern_.insert(i, j) = 0.0;
  pattern_.makeCompressed();

  const auto position = [&](int row, int column) {
    const int* begin = pattern_.innerIndexPtr() + pattern_.outerIndexPtr()[column];
    const int* end = pattern_.innerIndexPtr() + pattern_.outerIndexPtr()[column + 1];
    return static_cast<int>(std::lower_bound(begin, end, row) - pattern_.innerIndexPtr());
  };
  first_slot_.push_back(0);
  for (const auto& element : elements) {
    const int k = static_cast<int>(element.size());
    for (int b = 0; b < k; ++b)
      for (int a = 0; a < k; ++a)
        if (element[b] >= 0 && element[a] >= element[b])
          slots_.push_back({a + b * k, position(element[a], element[b])});
    first_slot_.push_back(static_cast<int>(slots_.size()));
  }
}

void SymmetricAssembler::add(int element, const double* element_matrix,
                             SymmetricMatrix& matrix) const {
  double* values = matrix.valuePtr();
  for (int s = first_slot_[element]; s < first_slot_[element + 1]; ++s)
    values[slots_[s].target] += element_matrix[slots_[s].source];
}

}  // namespace tencer::linalg
