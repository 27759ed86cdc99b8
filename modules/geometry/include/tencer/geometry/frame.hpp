// Frames about given points, whose corners can be anchors (paper section 5.2, figure 11).
#pragma once

#include <Eigen/Core>

namespace tencer::geometry {

enum class FrameShape { cube, tetrahedron };

// The corners of the smallest cube or regular tetrahedron with faces of the given directions (along
// the axes for a cube) that all lie `margin` or more beyond every point; 3 x 8 or 3 x 4. planar: a
// square or an equilateral triangle in the points' z, 3 x 4 or 3 x 3. points: 3 x n. Throws
// std::invalid_argument without points or with a margin that is not positive.
Eigen::Matrix3Xd enclosing_frame(FrameShape shape, const Eigen::Matrix3Xd& points, double margin,
                                 bool planar);

}  // namespace tencer::geometry
