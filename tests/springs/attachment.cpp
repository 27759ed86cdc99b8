#include <catch2/catch.hpp>
#include <tencer/springs/cable.hpp>
#include <vector>

namespace tencer::springs {
namespace {

// A closed quadrilateral and an open chain, unevenly divided.
struct Rods {
  std::vector<geometry::ArcLength> lengths{{Eigen::Vector4d(0.1, 0.7, 0.3, 0.2), true},
                                           {Eigen::Vector3d(0.5, 0.25, 0.3), false}};
  std::vector<Eigen::Matrix3Xd> x{Eigen::Matrix3Xd(3, 4), Eigen::Matrix3Xd(3, 4)};
  Eigen::Matrix3Xd anchors = Eigen::Vector3d(1, -2, 3);

  Rods() {
    x[0] << 0, 1, 2, -1, 0, 0.5, 2, 1, 0, 1, 0, 0.3;
    x[1] << 3, 1, 0, -1, 1, 2.5, 2, 0, 0, 1, 4, 0.7;
  }
  Eigen::Vector3d span(const Cable& cable, geometry::Side side = geometry::Side::after) const {
    return span_of(stencil(cable, lengths, anchors, side),
                   [&](int rod, int vertex) { return Eigen::Vector3d(x[rod].col(vertex)); });
  }
  Eigen::Vector3d point(int rod, double s) const {
    return span({.a = AtAnchor{0}, .b = OnRod{rod, s}}) + anchors.col(0);
  }
};

}  // namespace

TEST_CASE("a span goes from end a to end b") {
  const Rods rods;
  const Eigen::Vector3d a = 0.5 * (rods.x[0].col(1) + rods.x[0].col(2));
  const Eigen::Vector3d b = 0.8 * rods.x[1].col(2) + 0.2 * rods.x[1].col(3);
  const End on_first = OnRod{0, 0.1 + 0.35};
  const End on_second = OnRod{1, 0.75 + 0.06};
  CHECK((rods.span({.a = on_first, .b = on_second}) - (b - a)).norm() < 1e-14);
  CHECK((rods.span({.a = on_second, .b = on_first}) - (a - b)).norm() < 1e-14);
  CHECK((rods.span({.a = on_first, .b = AtAnchor{0}}) - (rods.anchors.col(0) - a)).norm() < 1e-14);
}

TEST_CASE("attachments go round a closed rod and stop at the ends of an open one") {
  const Rods rods;
  const double length = rods.lengths[0].length();
  CHECK((rods.point(0, length) - rods.x[0].col(0)).norm() < 1e-15);
  CHECK((rods.point(0, 0) - rods.x[0].col(0)).norm() < 1e-15);
  CHECK((rods.point(0, -2 * length) - rods.x[0].col(0)).norm() < 1e-15);
  CHECK((rods.point(0, -0.05) - rods.point(0, length - 0.05)).norm() < 1e-15);
  CHECK((rods.point(0, 5 * length + 0.3) - rods.point(0, 0.3)).norm() < 1e-14);
  // On the last edge, which joins the last vertex to the first.
  CHECK((rods.point(0, -0.05) - (0.75 * rods.x[0].col(0) + 0.25 * rods.x[0].col(3))).norm() <
        1e-14);
  CHECK((rods.point(1, -1) - rods.x[1].col(0)).norm() < 1e-15);
  CHECK((rods.point(1, 7) - rods.x[1].col(3)).norm() < 1e-15);
}

TEST_CASE("at a vertex either side gives the same point on its own edge") {
  const Rods rods;
  const struct {
    int rod, vertex, edge_after, edge_before;
  } cases[] = {{0, 0, 0, 3}, {0, 2, 2, 1}, {1, 1, 1, 0}, {1, 0, 0, 0}, {1, 3, 2, 2}};
  for (const auto& c : cases) {
    const Cable cable{.a = AtAnchor{0}, .b = OnRod{c.rod, rods.lengths[c.rod].knots()[c.vertex]}};
    const auto edge = [&](geometry::Side side) {
      return stencil(cable, rods.lengths, rods.anchors, side).shares[0].vertex;
    };
    CHECK(edge(geometry::Side::after) == c.edge_after);
    CHECK(edge(geometry::Side::before) == c.edge_before);
    for (const auto side : {geometry::Side::after, geometry::Side::before})
      CHECK((rods.span(cable, side) - (rods.x[c.rod].col(c.vertex) - rods.anchors.col(0))).norm() <
            1e-15);
  }
}

}  // namespace tencer::springs
