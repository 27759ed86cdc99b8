// What a design is and promises does not depend on where the target is, on how it is turned, or on
// how its rods and vertices are numbered. Which cables elimination ends with does: it goes on until
// rounding decides between two that are as good.
#include <Eigen/Geometry>
#include <functional>
#include <numbers>
#include <tencer/geometry/measure.hpp>
#include <tencer/ground_structure/force_balance.hpp>
#include <tencer/pipeline/simulate.hpp>

#include "scenes.hpp"

using namespace tencer;

namespace {

// A bent ring without symmetry, for with one several networks are as good.
geometry::Polyline ring(int vertices, double phase) {
  geometry::Polyline ring = curves::ellipse(32.5, 25, vertices);
  for (int i = 0; i < vertices; ++i) {
    const double phi = 2 * std::numbers::pi * i / vertices + phase;
    ring.points(0, i) += 3 * std::sin(2 * phi);
    ring.points(2, i) += 8 * std::cos(2 * phi) + 3 * std::sin(3 * phi);
  }
  return ring;
}

// Two of them, the second through the first.
model::Scene linked_scene() {
  std::vector<geometry::Polyline> rings{ring(24, 0.3), ring(20, 1.1)};
  rings[1].points.row(1).swap(rings[1].points.row(2));
  rings[1].points.colwise() += Eigen::Vector3d(30, 1, 2);
  return scene_of(rings);
}

// A place on a rod: which, and at what part of its length.
struct Place {
  int rod = 0;
  double part = 0.0;
};

// Another way to see the same rods, all of them closed.
struct View {
  std::string name;
  std::function<Eigen::Vector3d(const Eigen::Vector3d&)> move;
  int first = 0;          // vertex of the rods at which they begin
  bool reversed = false;  // run through the other way, from there
  bool reordered = false;

  int vertex(int i, int vertices) const {
    return (first + (reversed ? -i : i) + 2 * vertices) % vertices;
  }
  int edge(int i, int edges) const { return vertex(reversed ? i + 1 : i, edges); }

  Eigen::Matrix3Xd points(const Eigen::Matrix3Xd& points) const {
    Eigen::Matrix3Xd result(3, points.cols());
    const auto vertices = static_cast<int>(points.cols());
    for (int i = 0; i < vertices; ++i) result.col(i) = move(points.col(vertex(i, vertices)));
    return result;
  }
  // Of a place in the view: where it is.
  Place seen(Place at, const std::vector<Eigen::VectorXd>& rest_lengths) const {
    const auto rods = static_cast<int>(rest_lengths.size());
    if (reordered) at.rod = rods - 1 - at.rod;
    const double start = rest_lengths[at.rod].head(first).sum() / rest_lengths[at.rod].sum();
    const double part = start + (reversed ? -at.part : at.part);
    return {at.rod, part - std::floor(part)};
  }
};

const auto in_place = [](const Eigen::Vector3d& x) -> Eigen::Vector3d { return x; };

std::vector<View> views() {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.2, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  const auto elsewhere = [turn](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    return turn * x + Eigen::Vector3d(70, -10, 40);
  };
  return {
      {.name = "turned and moved", .move = elsewhere},
      {.name = "begun at another vertex", .move = in_place, .first = 7},
      {.name = "run through the other way", .move = in_place, .reversed = true},
      {.name = "in another order", .move = in_place, .reordered = true},
      {.name = "all of these", .move = elsewhere, .first = 5, .reversed = true, .reordered = true}};
}

// A cable with its ends in an order that does not depend on which is which.
struct Cable {
  Place a, b;
  double tension = 0.0;
};

bool same(const Place& a, const Place& b) {
  const double apart = std::abs(a.part - b.part);
  return a.rod == b.rod && std::min(apart, 1 - apart) < 1e-9;
}

const Cable* find(const std::vector<Cable>& cables, const Cable& like) {
  for (const Cable& cable : cables)
    if ((same(cable.a, like.a) && same(cable.b, like.b)) ||
        (same(cable.a, like.b) && same(cable.b, like.a)))
      return &cable;
  return nullptr;
}

// The size in which distances are told, by definition that of a box along the axes.
double size_of(const std::vector<Eigen::Matrix3Xd>& targets) {
  std::vector<geometry::Polyline> curves;
  for (const auto& points : targets) curves.push_back({.points = points});
  return geometry::bounding_box_diagonal(curves);
}

struct Balanced {
  std::vector<Cable> cables{};
  std::vector<Eigen::VectorXd> rest_lengths{};
  double max_distance = 0.0;  // of the total length
};

Balanced balanced(const model::Scene& scene) {
  const auto problem = prepared_of(scene).problem;
  const double size = size_of(problem.target.points);
  const auto stage =
      ground_structure::force_balance(problem, nullptr, {.max_error_percent = 0.03 / size});
  REQUIRE(stage.valid());
  Balanced result{.max_distance = stage.trace.back().max_percent / 100 * size};
  for (const auto& rod : stage.network.structure.rods)
    result.rest_lengths.push_back(rod.rest_lengths);
  const Eigen::VectorXd tensions = network::cable_tensions(stage.network);
  const auto place = [&](const springs::End& end) -> Place {
    const auto& on_rod = std::get<springs::OnRod>(end);
    return {on_rod.rod, on_rod.s / result.rest_lengths[on_rod.rod].sum()};
  };
  const auto& cables = stage.network.structure.cables;
  for (std::size_t c = 0; c < cables.size(); ++c)
    result.cables.push_back({place(cables[c].a), place(cables[c].b), tensions[c]});
  return result;
}

}  // namespace

TEST_CASE("the network that balances forces is the same however its target is seen") {
  const auto scene = GENERATE(scene_of({ring(30, 0.3)}), linked_scene());
  const Balanced here = balanced(scene);
  REQUIRE(here.cables.size() > 5);
  for (const View& view : views()) {
    CAPTURE(view.name, scene.structure.rods.size());
    model::Scene seen = scene;
    for (std::size_t r = 0; r < seen.target.points.size(); ++r)
      retarget(seen, r, view.points(seen.target.points[r]));
    if (view.reordered) {
      std::ranges::reverse(seen.structure.rods);
      std::ranges::reverse(seen.target.points);
      std::ranges::reverse(seen.target.weights);
      std::ranges::reverse(seen.directors);
    }
    const Balanced there = balanced(seen);
    CHECK(there.max_distance == Approx(here.max_distance).epsilon(1e-5));
    REQUIRE(there.cables.size() == here.cables.size());
    for (const Cable& cable : there.cables) {
      const Cable* const like = find(here.cables, {view.seen(cable.a, here.rest_lengths),
                                                   view.seen(cable.b, here.rest_lengths)});
      REQUIRE(like != nullptr);
      CHECK(cable.tension == Approx(like->tension).epsilon(1e-5));
    }
  }
}

TEST_CASE("what a design promises it keeps however it is seen") {
  const model::Design design = designed(linked_scene());
  REQUIRE(design.certificate->stable);
  REQUIRE(design.error->max_percent <= 1);
  std::vector<Eigen::VectorXd> rest_lengths;
  for (const auto& rod : design.structure.rods) rest_lengths.push_back(rod.rest_lengths);
  const auto rods = static_cast<int>(rest_lengths.size());
  for (const View& view : views()) {
    CAPTURE(view.name);
    model::Design seen = design;
    for (int r = 0; r < rods; ++r) {
      seen.target[r] = view.points(design.target[r]);
      seen.pose[r] = view.points(design.pose[r]);
      Eigen::VectorXd& lengths = seen.structure.rods[r].rest_lengths;
      const auto edges = static_cast<int>(lengths.size());
      for (int i = 0; i < edges; ++i) lengths[i] = rest_lengths[r][view.edge(i, edges)];
    }
    if (view.reordered) {
      std::ranges::reverse(seen.structure.rods);
      std::ranges::reverse(seen.target);
      std::ranges::reverse(seen.pose);
    }
    // Looked at the other way round, the view is undone.
    for (auto& cable : seen.structure.cables)
      for (springs::End* end : {&cable.a, &cable.b}) {
        auto& at = std::get<springs::OnRod>(*end);
        const double length = rest_lengths[at.rod].sum();
        const double start = rest_lengths[at.rod].head(view.first).sum();
        const double s = view.reversed ? start - at.s : at.s - start;
        at.s = s - length * std::floor(s / length);
        if (view.reordered) at.rod = rods - 1 - at.rod;
      }
    const auto found = pipeline::simulate(seen, {.start = pipeline::Start::target});
    REQUIRE(found);
    REQUIRE(found->usable());
    CHECK(found->moved_percent < 1e-4);
    const model::Design& there = found->design;
    const double scale = size_of(design.target) / size_of(there.target);
    CHECK(there.error->max_percent == Approx(scale * design.error->max_percent).epsilon(1e-4));
    CHECK(there.error->rms_percent == Approx(scale * design.error->rms_percent).epsilon(1e-4));
    CHECK(there.certificate->stable);
    CHECK(there.certificate->smallest_eigenvalue ==
          Approx(design.certificate->smallest_eigenvalue).epsilon(1e-4));
    for (std::size_t c = 0; c < design.built.size(); ++c)
      CHECK(there.built[c].tension == Approx(design.built[c].tension).epsilon(1e-4));
  }
}
