// Checks in real units against closed forms, and alike in other units.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tencer/model/material.hpp>
#include <tencer/pipeline/check.hpp>
#include <tencer/pipeline/shoves.hpp>
#include <tencer/pipeline/vibrations.hpp>

using namespace tencer;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinRel;

namespace {

constexpr double length_cm = 50;
constexpr double radius_cm = 0.1;
constexpr double youngs_modulus = 4e6;  // N/cm^2
constexpr int edges = 60;

// A straight glass fibre rod along x, in lengths of `centimetre` times a cm.
model::Design rod(double centimetre, const std::string& length_unit) {
  model::Design design;
  design.length_unit = length_unit;
  const double length = length_cm * centimetre;
  design.structure.rods = {{.section = der::solid_circle(youngs_modulus / (centimetre * centimetre),
                                                         0.3, radius_cm * centimetre),
                            .rest_lengths = Eigen::VectorXd::Constant(edges, length / edges)}};
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, edges + 1);
  x.row(0) = Eigen::RowVectorXd::LinSpaced(edges + 1, 0, length);
  design.target = design.pose = {x};
  design.target_directors = design.pose_directors = {Eigen::Matrix3Xd(3, 0)};
  return design;
}

model::Design cantilever() {
  model::Design design = rod(1, "cm");
  design.structure.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 1}};
  return design;
}

// Bent by a string between its ends, 5 % shorter than the rod.
model::Design bow(double centimetre, const std::string& length_unit) {
  model::Design design = rod(centimetre, length_unit);
  const double length = length_cm * centimetre;
  design.structure.cables = {{.a = springs::OnRod{0, 0}, .b = springs::OnRod{0, length}}};
  for (int i = 0; i <= edges; ++i)
    design.pose[0](1, i) = 0.2 * length * std::sin(std::numbers::pi * i / edges);
  design.target = design.pose;
  design.built = {{.length = 0.95 * length, .tension = 1}};
  return design;
}

// Pinned at its ends.
model::Design swinging_arch() {
  model::Design arch = bow(1, "cm");
  arch.structure.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = edges}};
  arch.structure.cables.clear();
  arch.built.clear();
  arch.pose[0].row(0) *= 0.9;
  arch.target = arch.pose;
  return arch;
}

}  // namespace

TEST_CASE("a glass fibre rod clamped at one end sounds and sags as a beam, in Hz and cm") {
  const auto checked = pipeline::check(cantilever());
  REQUIRE(checked);
  const model::Check& check = checked->check;
  REQUIRE(check.stands);
  CHECK(check.stands->certified);
  CHECK(check.stands->free_groups.empty());
  const double radius = radius_cm / 100, length = length_cm / 100 * (1 - 0.5 / edges);  // m
  const double bending = youngs_modulus * 1e4 * std::numbers::pi * std::pow(radius, 4) / 4;
  const double mass = *model::glass_fibre().density * std::numbers::pi * radius * radius;
  REQUIRE(check.stands->hertz.size() == 10);
  CHECK_THAT(check.stands->hertz[0],
             WithinRel(3.516015 / (2 * std::numbers::pi) *
                           std::sqrt(bending / (mass * std::pow(length, 4))),
                       2e-3));
  REQUIRE(check.weight);
  REQUIRE(check.weight->hung);
  CHECK(check.weight->held);
  CHECK_FALSE(check.weight->standing);
  CHECK_THAT(check.weight->hung->deviation / 100,
             WithinRel(mass * 9.81 * std::pow(length, 4) / (8 * bending), 5e-3));
  REQUIRE(check.forgives);
  CHECK(check.forgives->worst == 0);
  REQUIRE(check.converged);
  CHECK(check.converged->converged);
  REQUIRE(check.comes_back);
  for (const auto& pushes : check.comes_back->pushes) CHECK(pushes.back == pushes.tried);
  CHECK(model::shortfalls(check, {"cm", "N"}).empty());
}

TEST_CASE("a design's vibrations are those of its check, and a clamped end stays where it is") {
  const auto checked = pipeline::check(cantilever());
  REQUIRE(checked);
  const auto found = pipeline::vibrations(checked->design, 3);
  REQUIRE(found.size() == 3);
  for (std::size_t i = 0; i < 3; ++i)
    CHECK_THAT(found[i].hertz, WithinRel(checked->check.stands->hertz[i], 1e-9));
  REQUIRE(found[0].shape.size() == 1);
  CHECK(found[0].shape[0].leftCols(2).norm() == 0);
  CHECK_THAT(found[0].shape[0].col(edges).cwiseAbs().maxCoeff(), WithinRel(1.0, 1e-9));
}

TEST_CASE("the shoves that are shown are pushed as far as those of the check") {
  const auto checked = pipeline::check(bow(1, "cm"));
  REQUIRE(checked);
  const auto& pushes = checked->check.comes_back->pushes.back();
  CHECK(pushes.back == pushes.tried);
  const auto shoves = pipeline::shoves(checked->design);
  REQUIRE(shoves.size() == 2);
  CHECK(shoves[0].smooth);
  CHECK_FALSE(shoves[1].smooth);
  for (const pipeline::Shove& shove : shoves) {
    CHECK(shove.size == Approx(pushes.size));
    CHECK(shove.back);
    REQUIRE(shove.poses.size() > 2);
    const Eigen::Matrix3Xd left = shove.poses.back()[0] - checked->design.pose[0];
    CHECK(left.colwise().norm().maxCoeff() < 1e-6 * shove.size);
  }
}

TEST_CASE("weight that is among the loads is in the pose") {
  model::Design design = cantilever();
  design.structure.line_loads = {{.rod = 0, .force_per_length = {0, 0, -1e-5}}};
  const auto checked = pipeline::check(design);
  REQUIRE(checked);
  REQUIRE(checked->check.weight);
  CHECK(checked->check.weight->included);
  CHECK_FALSE(checked->check.weight->hung);
  CHECK_THAT(model::report(checked->check, {"cm", "N"}), Contains("weight: the pose has it"));
}

TEST_CASE("a bow's check says the same in cm and mm") {
  const auto cm = pipeline::check(bow(1, "cm"));
  const auto mm = pipeline::check(bow(10, "mm"));
  REQUIRE(cm);
  REQUIRE(mm);
  REQUIRE(cm->check.holds);
  REQUIRE(mm->check.holds);
  CHECK_THAT(mm->check.holds->tension, WithinRel(cm->check.holds->tension, 1e-6));
  CHECK_THAT(mm->check.holds->strain, WithinRel(cm->check.holds->strain, 1e-6));
  CHECK_THAT(mm->check.weight->hung->deviation,
             WithinRel(10 * cm->check.weight->hung->deviation, 1e-5));
  CHECK_THAT(mm->check.stands->hertz[0], WithinRel(cm->check.stands->hertz[0], 1e-5));
  CHECK_THAT(mm->check.forgives->percentile_95,
             WithinRel(10 * cm->check.forgives->percentile_95, 1e-5));
  // A string 1 mm longer or shorter parts the ends by as much.
  CHECK(cm->check.forgives->worst > 0.02);
  CHECK(cm->check.forgives->decisive_cable == 0);
  CHECK(cm->check.forgives->settled == 30);
  CHECK(cm->check.forgives->fallen == 0);
  CHECK(cm->check.forgives->settled_worst <= 1.05 * cm->check.forgives->worst);
  const std::string text = model::report(cm->check, {"cm", "N"});
  CHECK_THAT(text, Contains("cables cut to 1 mm and tied to 2 mm: within "));
}

TEST_CASE("an arch that swings about the line through its pins fails, and the line is named") {
  const auto checked = pipeline::check(swinging_arch());
  REQUIRE(checked);
  const auto fails = model::shortfalls(checked->check, {"cm", "N"});
  CHECK(std::ranges::any_of(fails, [](const auto& fail) {
    return fail.starts_with("stands: the rod turns about the line through (");
  }));
}

TEST_CASE("a swinging arch is tied to anchors on both sides of it, and cannot be to one side's") {
  model::Design arch = swinging_arch();
  const auto untied = pipeline::check(arch, {.repair = true});
  REQUIRE(untied);
  CHECK_THAT(model::report(untied->check, {"cm", "N"}),
             Contains("fails: repair: not possible: no cables were found between rods, or to "
                      "anchors"));

  const double height = arch.pose[0].row(1).maxCoeff();
  arch.structure.anchors = Eigen::Matrix3Xd{{25, 25}, {height / 2, height / 2}, {30, -30}};
  const auto tied = pipeline::check(arch, {.repair = true});
  REQUIRE(tied);
  REQUIRE(tied->check.repair);
  const model::Repair& repair = *tied->check.repair;
  CHECK(repair.problem.empty());
  CHECK(repair.cables == 2);
  CHECK(repair.least_tension > 0);
  CHECK(repair.moved < 0.01 * 50);
  CHECK(tied->design.structure.cables.size() == 2);
  CHECK(tied->check.stands->certified);
  CHECK(tied->check.stands->free_groups.empty());
}

TEST_CASE("bows through each other that nothing ties are tied with few cables, where they are") {
  model::Design bows = bow(1, "cm");
  const model::Design other = bow(1, "cm");
  bows.structure.rods.push_back(other.structure.rods[0]);
  bows.structure.cables.push_back({.a = springs::OnRod{1, 0}, .b = springs::OnRod{1, length_cm}});
  bows.built.push_back(other.built[0]);
  // Each rod passes between the other's rod and string.
  const auto across = [](const Eigen::Matrix3Xd& x) {
    Eigen::Matrix3Xd turned(3, x.cols());
    turned << x.row(2).array() + length_cm / 2, 10.5 - x.row(1).array(),
        x.row(0).array() - length_cm / 2;
    return turned;
  };
  for (auto* points : {&bows.pose, &bows.target}) points->push_back(across(points->front()));
  bows.target_directors.push_back(other.target_directors[0]);
  bows.pose_directors.push_back(other.pose_directors[0]);
  // Errors take their time, and are no matter here.
  pipeline::CheckOptions options{.length_error_mm = 0, .attachment_error_mm = 0};
  const auto loose = pipeline::check(bows, options);
  REQUIRE(loose);
  CHECK(loose->check.stands->free_groups.size() == 2);
  options.repair = true;
  const auto tied = pipeline::check(bows, options);
  REQUIRE(tied);
  REQUIRE(tied->check.repair);
  const model::Repair& repair = *tied->check.repair;
  CHECK(repair.problem.empty());
  CHECK(repair.cables >= 4);
  CHECK(repair.cables <= 10);
  CHECK(repair.moved < 0.01 * 60);
  CHECK(tied->check.stands->certified);
  CHECK(tied->check.stands->free_groups.empty());
}

TEST_CASE("strain, tension and deviation beyond what is allowed fail") {
  const auto checked =
      pipeline::check(bow(1, "cm"), {.max_deviation = {0.01, "mm"}, .breaking_load_newtons = 1e-3});
  REQUIRE(checked);
  const auto fails = model::shortfalls(checked->check, {"cm", "N"});
  const auto named = [&](const std::string& start) {
    return std::ranges::any_of(fails, [&](const auto& fail) { return fail.starts_with(start); });
  };
  CHECK(named("forgives: with cables cut to 1 mm"));
  CHECK(named("holds: cable 1 pulls with"));
}

TEST_CASE("options out of range are refused") {
  CHECK_THROWS_AS(pipeline::check(cantilever(), {.length_error_mm = -1}), std::invalid_argument);
  CHECK_THROWS_AS(pipeline::check(cantilever(), {.max_deviation = {0, "mm"}}),
                  std::invalid_argument);
  CHECK_THROWS_AS(pipeline::check(cantilever(), {.draws = 0}), std::invalid_argument);
}
