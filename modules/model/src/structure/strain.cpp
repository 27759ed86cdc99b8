#include <tencer/der/curvature.hpp>
#include <tencer/model/strain.hpp>

namespace tencer::model {
namespace {

std::optional<BendingStrain> largest(const der::Rod& rod, const der::RodState& state) {
  if (!der::half_sizes(rod.section.shape)) return std::nullopt;
  const Eigen::Matrix2Xd curvature = der::bending_curvature(rod, state);
  BendingStrain worst;
  for (int b = 0; b < rod.bending_vertices(); ++b) {
    const double strain = *der::bending_strain(rod.section.shape, curvature(0, b), curvature(1, b));
    if (strain > worst.strain)
      worst = {
          .strain = strain, .curvature = curvature.col(b).norm(), .vertex = rod.bending_vertex(b)};
  }
  worst.s = rod.rest_lengths.head(worst.vertex).sum();
  return worst;
}

}  // namespace

std::vector<std::optional<BendingStrain>> largest_bending_strains(const Structure& structure,
                                                                  const State& state) {
  std::vector<std::optional<BendingStrain>> result;
  for (std::size_t r = 0; r < structure.rods.size(); ++r)
    result.push_back(largest(structure.rods[r], state[r]));
  return result;
}

}  // namespace tencer::model
