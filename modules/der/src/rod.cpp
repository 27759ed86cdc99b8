#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/der/rod.hpp>

namespace tencer::der {

void validate(const Rod& rod) {
  core::require(rod.edges() >= (rod.closed ? 3 : 1),
                "rod: needs at least 3 edges when closed, 1 when open");
  core::require(rod.rest_lengths.allFinite() && rod.rest_lengths.minCoeff() > 0,
                "rod: rest_lengths must be positive");
  const Section& s = rod.section;
  for (double stiffness : {s.EA, s.EI1, s.EI2, s.GJ})
    core::require(stiffness > 0 && std::isfinite(stiffness),
                  "rod: EA, EI and GJ of the section must be positive");
  core::require(
      rod.rest_curvature.size() == 0 ||
          (rod.rest_curvature.cols() == rod.bending_vertices() && rod.rest_curvature.allFinite()),
      "rod: rest_curvature needs one finite column per bending vertex");
  core::require(rod.rest_twist.size() == 0 ||
                    (rod.rest_twist.size() == rod.bending_vertices() && rod.rest_twist.allFinite()),
                "rod: rest_twist needs one finite entry per bending vertex");
  core::require(!rod.closing_angle || (rod.closed && std::isfinite(*rod.closing_angle)),
                "rod: closing_angle is for closed rods and must be finite");
  core::require(!rod.closed || (!rod.clamp_start_frame && !rod.clamp_end_frame),
                "rod: clamped frames are for open rods");
}

TwistModel twist_model(const Rod& rod) {
  const bool straight = rod.rest_curvature.size() == 0 || rod.rest_curvature.isZero(0);
  const bool held = rod.clamp_start_frame && rod.clamp_end_frame;
  if (!rod.section.isotropic() || !straight || held) return TwistModel::per_edge;
  return rod.closing_angle ? TwistModel::uniform : TwistModel::none;
}

}  // namespace tencer::der
