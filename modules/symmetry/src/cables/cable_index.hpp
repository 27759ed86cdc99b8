// Looks up cables by the places they join.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <tencer/geometry/arc_length.hpp>
#include <tencer/springs/cable.hpp>
#include <unordered_map>
#include <vector>

namespace tencer::symmetry {

// How far apart two ends are, over the rod's length; infinite on different rods or anchors.
double apart(const springs::End& a, const springs::End& b,
             std::span<const geometry::ArcLength> rods);

class CableIndex {
 public:
  // Cables whose ends are at most `tolerance` apart are the same. The rods must outlive the index.
  CableIndex(std::span<const geometry::ArcLength> rods, double tolerance);

  void add(const springs::Cable& cable, int value);

  // The value of the cable added that is nearest to this one, if it is the same; swapped: its end a
  // is this one's end b. Of equally near ones the one added first.
  struct Found {
    int value = 0;
    bool swapped = false;
  };
  std::optional<Found> find(const springs::Cable& cable) const;

 private:
  struct Entry {
    springs::Cable cable;
    int value;
  };
  std::uint64_t cell(const springs::End& end, int step) const;

  std::span<const geometry::ArcLength> rods_;
  double tolerance_;
  std::uint64_t cells_;  // a rod is divided into; none is shorter than the tolerance
  std::vector<Entry> entries_;
  std::unordered_map<std::uint64_t, std::vector<int>> by_cells_;
};

}  // namespace tencer::symmetry
