// Designs from start to end: what they claim is so, and stays so through the file and back to rest.
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <tencer/geometry/measure.hpp>
#include <tencer/pipeline/simulate.hpp>

#include "scenes.hpp"

using namespace tencer;

namespace {

model::Design through_a_file(const model::Design& design) {
  const auto path =
      std::filesystem::temp_directory_path() / ("tencer-" + std::to_string(::getpid()) + ".json");
  const auto failed = io::write_design(path, design);
  if (failed) FAIL(failed->text());
  const auto read = io::read_design(path);
  std::filesystem::remove(path);
  if (!read) FAIL(read.error().text());
  return *read;
}

void check_rests_in_its_pose(const model::Design& design,
                             const pipeline::SimulateOptions& options) {
  const auto simulation = pipeline::simulate(design, options);
  REQUIRE(simulation);
  CHECK(simulation->usable());
  CHECK(simulation->moved_percent <= 0.01);
  CHECK(simulation->design.status == design.status);
}

// The largest distance of these points from a line.
double farthest(const Eigen::Matrix3Xd& points, const Eigen::Matrix3Xd& line) {
  double most = 0;
  for (const Eigen::Vector3d p : points.colwise()) {
    double nearest = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i + 1 < line.cols(); ++i)
      nearest = std::min(nearest,
                         geometry::segment_approach(p, p, line.col(i), line.col(i + 1)).distance);
    most = std::max(most, nearest);
  }
  return most;
}

// Of ever fewer cables, that end on the rod, which is about as far from the target as they say.
void check_snapshots(const model::Design& design) {
  std::vector<model::Snapshot> seen;
  for (const auto& row : design.trace)
    seen.insert(seen.end(), row.snapshots.begin(), row.snapshots.end());
  REQUIRE(seen.size() >= 3);
  CHECK(seen.size() <= 20);
  CHECK(seen.front().cables() > 2 * seen.back().cables());
  Eigen::Matrix3Xd target(3, design.target[0].cols() + 1);
  target << design.target[0], design.target[0].col(0);
  const double size = model::diagonal({.points = design.target});
  for (const model::Snapshot& one : seen) {
    REQUIRE(one.rods.size() == 1);
    CHECK(one.rods[0].col(0) == one.rods[0].rightCols<1>());
    REQUIRE(one.cable_ends.cols() == 2 * one.cables());
    CHECK(farthest(one.cable_ends, one.rods[0]) <= 1e-9 * size);
    CHECK(farthest(one.rods[0], target) <= (one.max_percent + 1) / 100 * size);
  }
}

}  // namespace

// The stages that each method goes through.
const std::map<model::Method, std::vector<std::string>> stages_of{
    {model::Method::force_balance, {"balance", "eliminate"}},
    {model::Method::dense_springs, {"prune", "greedy", "sparsify", "slide", "eliminate"}}};

TEST_CASE("a closed rod: the design stands, and rests where its file says") {
  const auto method = GENERATE(model::Method::force_balance, model::Method::dense_springs);
  model::Scene scene = trefoil_scene();
  scene.design.method = method;
  scene.design.effort = 2;  // a quick search from dense springs finds none that forgives errors
  std::set<std::string> reported;
  const model::Design design =
      designed(scene, {.progress = [&](const network::Progress& progress) {
                 reported.insert(std::string(progress.stage));
                 // A stage that begins has no network yet.
                 CHECK((progress.cables == 0) == std::isnan(progress.max_percent));
                 CHECK(progress.seconds >= 0);
               }});

  CHECK(design.status == model::DesignStatus::complete);
  check_consistent(design);
  CHECK(design.error->max_percent <= scene.design.max_error);
  CHECK(design.certificate->stable);
  CHECK(design.certificate->smallest_eigenvalue > 0);
  CHECK(design.certificate->residual <= 1e-6);
  CHECK(design.certificate->slack_cables == 0);
  CHECK(design.certificate->settles_from_target == true);
  CHECK(design.structure.cables.size() < 40);  // of the 740 that its vertices have
  REQUIRE(design.at_least);
  CHECK(design.at_least->cables <= static_cast<int>(design.structure.cables.size()));
  CHECK(design.target == scene.target.points);

  std::set<std::string> recorded;
  for (const auto& row : design.trace) recorded.insert(row.stage);
  for (const auto& stage : stages_of.at(method)) {
    CAPTURE(stage);
    CHECK(reported.contains(stage));
    CHECK(recorded.contains(stage));
  }
  CHECK(design.trace.back().stage == "settle");
  check_snapshots(design);

  const model::Design read = through_a_file(design);
  model::Design unchecked = design;
  unchecked.check.reset();
  CHECK(io::design_text(read) == io::design_text(unchecked));
  check_rests_in_its_pose(read, {.start = pipeline::Start::pose});
  check_rests_in_its_pose(read, {.start = pipeline::Start::target});
  check_rests_in_its_pose(read,
                          {.start = pipeline::Start::pose, .cables = pipeline::Cables::springs});
}

TEST_CASE("the same scene gives the same design") {
  const auto text = [] {
    model::Design design = designed(ellipse_scene());
    for (auto& row : design.trace) row.seconds = 0;
    return io::design_text(design);
  };
  CHECK(text() == text());
}

TEST_CASE("every optimizer of the build finds a design") {
  for (const auto& backend : pipeline::backends()) {
    CAPTURE(backend.name);
    model::Scene scene = ellipse_scene();
    scene.design.optimizer = optimizer_named(backend.name);
    const model::Design design = designed(scene);
    CHECK(design.status == model::DesignStatus::complete);
    check_consistent(design);
  }
}

TEST_CASE("rods that rest in the target need no cables") {
  const auto curve = GENERATE(
      curves::circle(25, 24),
      geometry::Polyline{(Eigen::Matrix3Xd(3, 4) << 0, 1, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0).finished(),
                         false});
  CAPTURE(curve.closed);
  const model::Design design = designed(scene_of({curve}));
  CHECK(design.structure.cables.empty());
  CHECK(design.status == model::DesignStatus::complete);
  check_consistent(design);
}

TEST_CASE("a tolerance that cannot be reached is said") {
  model::Scene scene = ellipse_scene();
  scene.design.max_error = 1e-9;
  const model::Design design = designed(scene);
  CHECK(design.status == model::DesignStatus::tolerance_not_reached);
  check_consistent(design);
}

TEST_CASE("springs need a stiffness in the file") {
  model::Design design = designed(ellipse_scene());
  REQUIRE_FALSE(design.structure.cables.empty());
  design.structure.cables.back().stiffness = 0;
  const auto simulation = pipeline::simulate(design, {.cables = pipeline::Cables::springs});
  REQUIRE_FALSE(simulation);
  CHECK(simulation.error().where ==
        "cables[" + std::to_string(design.structure.cables.size() - 1) + "]");
  CHECK(pipeline::simulate(design));
}

TEST_CASE("a cable whose ends meet is named") {
  model::Design design = designed(ellipse_scene());
  REQUIRE_FALSE(design.structure.cables.empty());
  design.structure.cables[0].b = design.structure.cables[0].a;
  const auto simulation = pipeline::simulate(design);
  REQUIRE_FALSE(simulation);
  CHECK(simulation.error().where == "cables[0]");
}

TEST_CASE("a simulation that cannot come to rest says so in its design") {
  const model::Design design = designed(ellipse_scene());
  pipeline::SimulateOptions options{.start = pipeline::Start::target};
  SECTION("stopped") {
    std::stop_source stop;
    stop.request_stop();
    options.solve.stop = stop.get_token();
    const auto simulation = pipeline::simulate(design, options);
    REQUIRE(simulation);
    CHECK_FALSE(simulation->usable());
    CHECK(simulation->design.status == model::DesignStatus::interrupted);
  }
  SECTION("out of iterations") {
    options.solve.max_iterations = 1;
    const auto simulation = pipeline::simulate(design, options);
    REQUIRE(simulation);
    CHECK_FALSE(simulation->usable());
    CHECK(simulation->design.status == model::DesignStatus::tolerance_not_reached);
  }
}
