#include "drawing/labels.hpp"

#include <catch2/catch.hpp>

using namespace tencer::app;
using Eigen::AlignedBox2d;
using Eigen::Vector2d;

TEST_CASE("Words are on their place where nothing is in the way") {
  Labels labels(AlignedBox2d(Vector2d(0, 0), Vector2d(100, 100)), {});
  CHECK(labels.place({{50, 50}}, {4, 3}, Beside::on).middle == Vector2d(50, 50));
  // A second one moves on to the next place that it may be at.
  CHECK(labels.place({{50, 51}, {60, 50}}, {4, 3}, Beside::on).middle == Vector2d(60, 50));
}

TEST_CASE("No words hide others, though all want the same place") {
  const AlignedBox2d bounds(Vector2d(0, 0), Vector2d(60, 60));
  Labels labels(bounds, {});
  const Vector2d size(5, 3);
  std::vector<AlignedBox2d> boxes;
  for (int i = 0; i < 40; ++i) {
    const Vector2d middle =
        labels.place({{30, 30}}, size, i % 2 == 0 ? Beside::on : Beside::near).middle;
    const AlignedBox2d box(middle - size / 2, middle + size / 2);
    CHECK(bounds.contains(box));
    for (const AlignedBox2d& other : boxes) CHECK_FALSE(other.intersects(box));
    boxes.push_back(box);
  }
}

TEST_CASE("Words beside a place keep off it, and off lines") {
  std::vector<Vector2d> line;
  for (double x = 0; x <= 100; x += 0.5) line.emplace_back(x, 50);
  Labels labels(AlignedBox2d(Vector2d(0, 0), Vector2d(100, 100)), line);
  const Vector2d size(5, 4);
  const Vector2d middle = labels.place({{50, 50}}, size, Beside::near).middle;
  CHECK(std::abs(middle.y() - 50) >= size.y() / 2);
  CHECK((middle - Vector2d(50, 50)).norm() < 10);
}

TEST_CASE("Leaders cross neither each other nor words") {
  const AlignedBox2d bounds(Vector2d(0, 0), Vector2d(80, 80));
  Labels labels(bounds, {});
  const Vector2d size(4, 3);
  std::vector<Placed> placed;
  // Places so near to each other that all words must go somewhere else; those for which there is no
  // room are not drawn.
  for (int i = 0; i < 20; ++i) {
    const Placed one = labels.place({{35 + 0.5 * i, 40}, {40, 35 + 0.5 * i}}, size, Beside::leader);
    if (one.clear) placed.push_back(one);
  }
  CHECK(placed.size() >= 6);
  const auto box_of = [&](const Placed& one) {
    return AlignedBox2d(one.middle - size / 2, one.middle + size / 2);
  };
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Vector2d end = edge_towards(box_of(placed[i]), placed[i].anchor);
    CHECK((end - placed[i].anchor).norm() > 1);
    for (std::size_t j = 0; j < placed.size(); ++j) {
      if (i == j) continue;
      // A tenth of the way at a time, but for the shared start of two at one place.
      for (int k = 1; k <= 10; ++k)
        CHECK_FALSE(box_of(placed[j]).contains(
            Vector2d(placed[i].anchor + 0.1 * k * (end - placed[i].anchor))));
    }
  }
}
