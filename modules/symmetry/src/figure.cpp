#include <tencer/core/error.hpp>
#include <tencer/symmetry/figure.hpp>

namespace tencer::symmetry {

void validate(const Figure& figure) {
  core::require(!figure.curves.empty(), "figure: needs at least one rod");
  core::require(figure.rods.size() == figure.curves.size(),
                "figure: needs one arc length for each curve");
  core::require(figure.classes.empty() || figure.classes.size() == figure.curves.size(),
                "figure: needs one class for each curve, or none at all");
  for (std::size_t r = 0; r < figure.curves.size(); ++r) {
    core::require(figure.rods[r].edges() == figure.curves[r].edges() &&
                      figure.rods[r].closed() == figure.curves[r].closed,
                  "figure: an arc length belongs to another curve");
    core::require(figure.curves[r].points.allFinite(), "figure: points must be finite");
  }
  core::require(figure.anchors.allFinite(), "figure: anchors must be finite");
}

}  // namespace tencer::symmetry
