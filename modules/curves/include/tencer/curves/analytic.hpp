// Families of target curves. Vertices lie on the smooth curve at equal arc length. Lengths are in
// any unit. The figures named are the paper's, whose models families.hpp has for defaults. All
// throw std::invalid_argument for fewer than 3 vertices (a helix: 2) and for sizes that are not
// positive, but for the pitch of a helix.
#pragma once

#include <tencer/geometry/polyline.hpp>
#include <vector>

namespace tencer::curves {

// (radius cos t, radius sin t, 0).
geometry::Polyline circle(double radius, int vertices);

// (semi_x cos t, semi_y sin t, 0).
geometry::Polyline ellipse(double semi_x, double semi_y, int vertices);

// Open; about the z axis, from (diameter/2, 0, 0) upwards, `pitch` a turn; right-handed.
geometry::Polyline helix(double diameter, double pitch, double turns, int vertices);

// ((R + r cos q t) cos p t, (R + r cos q t) sin p t, r sin q t): winds p times about the axis of
// the torus and q times about its inner circle (figure 10). R = major > r = minor > 0, p and q
// coprime, or throws std::invalid_argument.
geometry::Polyline torus_knot(int p, int q, double major, double minor, int vertices);

// Three closed curves of the trefoil's knot type with the given arc length (figure 9).
// hypotrochoid: (sin t + 2 sin 2t, cos t - 2 cos 2t, -sin 3t) scaled, the published model;
// torus_2_3 and torus_3_2: torus knots with minor = 0.4 major.
enum class TrefoilForm { hypotrochoid, torus_2_3, torus_3_2 };
geometry::Polyline trefoil(TrefoilForm form, double length, int vertices);

// Two (2,3) torus knots on the same torus, the second turned by pi/3 about its axis (figure 1);
// throws as torus_knot does.
std::vector<geometry::Polyline> twin_trefoils(double major, double minor, int vertices);

// Three congruent ellipses in mutually perpendicular planes, linked as Borromean rings (figure 12).
// long_axis > short_axis are semi-axes, or throws std::invalid_argument; each rod has `vertices`
// vertices.
std::vector<geometry::Polyline> borromean_ellipses(double long_axis, double short_axis,
                                                   int vertices);

}  // namespace tencer::curves
