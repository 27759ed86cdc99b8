// Networks and symmetries carried from the rods of one resolution to those of another.
#pragma once

#include <tencer/geometry/arc_length.hpp>
#include <tencer/network/network.hpp>
#include <tencer/symmetry/group.hpp>
#include <vector>

namespace tencer::elimination {

// The same rod at two resolutions: the edges of the one with fewer are equal on the other.
class ResolutionMap {
 public:
  ResolutionMap(const der::Rod& from, const der::Rod& to);

  double place(double s) const;  // the arc length on `to` of the one on `from`
  double factor() const { return to_.length() / from_.length(); }
  const geometry::ArcLength& to() const { return to_; }
  Eigen::Matrix3Xd positions(const Eigen::Matrix3Xd& x) const;  // of the vertices of `to`

 private:
  geometry::ArcLength from_, to_, common_from_, common_to_;
};

// One a rod.
std::vector<ResolutionMap> resolution_maps(const std::vector<der::Rod>& from,
                                           const std::vector<der::Rod>& to);

// The cable with its ends where they are on the other rods.
void transfer(springs::Cable& cable, const std::vector<ResolutionMap>& rods);

// The network on the rods of another resolution, cables as good as inextensible and with the same
// tensions: near an equilibrium.
network::Network transferred(const network::Network& network, const model::Structure& bare);

symmetry::Group transferred(const symmetry::Group& group, const std::vector<der::Rod>& from,
                            const std::vector<der::Rod>& to);

}  // namespace tencer::elimination
