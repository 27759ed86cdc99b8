// What it saves to leave out what a scene does not need: the same problem with each omission and
// without it, in one run. Times are medians; a design is made once, and its search takes other
// turns with other unknowns, so its ratio says less. Usage: bench_omissions [quick]
//
// "kept" means: theta where the two bending stiffnesses differ by 1e-6, which makes the library
// keep an angle an edge and changes nothing else; z where the scene does not say that it is planar;
// registration where rods are aligned although anchors hold them; anchors that no cable needs; a
// search for symmetries that are not there. Symmetry itself is the one part that is cheaper to use.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>
#include <tencer/curves/analytic.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/geometry/frame.hpp>
#include <tencer/ground_structure/force_balance.hpp>
#include <tencer/model/scene.hpp>
#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/prepare.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <vector>

using namespace tencer;

namespace {

double seconds_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// Median seconds over half a second, at least 5 times.
double median_seconds(const std::function<void()>& work) {
  std::vector<double> times;
  double sum = 0;
  while (times.size() < 5 || (sum < 0.5 && times.size() < 200)) {
    times.push_back(seconds_of(work));
    sum += times.back();
  }
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::ranges::nth_element(times, middle);
  return *middle;
}

model::Scene scene_of(const std::vector<geometry::Polyline>& curves) {
  return model::scene_of(curves, "bench");
}

model::Scene trefoil() {
  return scene_of({curves::trefoil(curves::TrefoilForm::hypotrochoid, 198, 102)});
}

void print(const char* part, const char* problem, const char* what, double left_out, double kept,
           const std::string& note) {
  std::printf("%-13s %-26s %-22s %10.4g %10.4g %7.2f  %s\n", part, problem, what, 1e3 * left_out,
              1e3 * kept, kept / left_out, note.c_str());
  std::fflush(stdout);
}

// A network that holds the scene's target.
struct Held {
  ground_structure::Problem problem;
  network::Network network;
};

ground_structure::Problem problem_of(const model::Scene& scene) {
  auto prepared = pipeline::prepare(scene);
  if (!prepared) throw std::runtime_error(prepared.error().text());
  return std::move(prepared->problem);
}

Held held(const model::Scene& scene) {
  Held held{.problem = problem_of(scene), .network = {}};
  held.network = ground_structure::force_balance(held.problem, nullptr).network;
  return held;
}

// The same cables on both scenes' rods: one factorisation, and the equilibrium from the target.
void compare_forward(const char* part, const char* problem, const model::Scene& left_out,
                     const model::Scene& kept) {
  const Held with = held(left_out);
  const ground_structure::Problem other = problem_of(kept);
  model::Structure structure = other.structure;
  structure.cables = with.network.structure.cables;
  const equilibrium::System small(with.network.structure);
  const equilibrium::System large(structure);
  const auto linearise = [](const equilibrium::System& system, const model::State& state) {
    equilibrium::Linearisation at;
    equilibrium::linearise(system, state, at);
    return median_seconds([&] { equilibrium::linearise(system, state, at); });
  };
  const std::string unknowns =
      std::to_string(small.size()) + " and " + std::to_string(large.size()) + " unknowns";
  print(part, problem, "Hessian and its factor", linearise(small, with.problem.start),
        linearise(large, other.start), unknowns);
  equilibrium::Equilibrium a, b;
  const double small_seconds =
      median_seconds([&] { a = equilibrium::solve(small, with.problem.start); });
  const double large_seconds = median_seconds([&] { b = equilibrium::solve(large, other.start); });
  // Where nothing holds them in space, solutions may lie differently there.
  model::Target there{.align = with.problem.target.align};
  for (const auto& rod : b.state) there.points.push_back(rod.x);
  const double apart = sensitivity::deviation(there, a.state).max;
  char note[120];
  std::snprintf(note, sizeof note, "%d and %d iterations, %.0e L apart%s", a.iterations,
                b.iterations, apart, a.usable() && b.usable() ? "" : ", NOT USABLE");
  print(part, problem, "equilibrium", small_seconds, large_seconds, note);
}

void compare_designs(const char* part, const char* problem, const model::Scene& left_out,
                     const model::Scene& kept) {
  std::string note;
  const auto design = [&](const model::Scene& scene) {
    return seconds_of([&] {
      const auto result = pipeline::design(scene);
      note += note.empty() ? "" : " and ";
      note += result ? std::to_string(result->built.size()) : result.error().text();
    });
  };
  const double a = design(left_out);
  const double b = design(kept);
  print(part, problem, "design", a, b, note + " cables");
}

// The distance of an equilibrium to the target and its rates of change with 50 parameters.
void compare_registration(const model::Scene& scene) {
  const Held anchored = held(scene);
  const equilibrium::System system(anchored.network.structure);
  const Eigen::MatrixXd rates = Eigen::MatrixXd::Random(system.size(), 50);
  const auto distance = [&](bool align) {
    model::Target target = anchored.problem.target;
    target.align = align;
    return median_seconds([&] {
      const sensitivity::Distance at(target, system, anchored.network.state);
      if (at.residual_rates(rates).size() == 0) std::abort();
    });
  };
  print("registration", "helix in a cube", "distance and its rates", distance(false),
        distance(true), "");
}

void compare_detection(const model::Scene& without) {
  model::Scene with = without;
  with.design.symmetry = model::SymmetryUse::detect;
  const auto prepare = [](const model::Scene& scene) {
    return median_seconds([&] {
      if (!pipeline::prepare(scene)) std::abort();
    });
  };
  print("symmetry", "a knot that has none", "preparation", prepare(without), prepare(with), "");
}

model::Scene unequal(model::Scene scene) {
  for (auto& rod : scene.structure.rods) rod.section.EI2 *= 1 + 1e-6;
  return scene;
}

model::Scene twisted(model::Scene scene) {
  scene.structure.rods[0].closing_angle = 6.283185307179586;
  return scene;
}

model::Scene planar_ellipses(bool planar) {
  geometry::Polyline inner = curves::ellipse(15, 6, 60);
  model::Scene scene = scene_of({curves::ellipse(32.5, 22, 100), inner});
  scene.structure.planar = scene.target.planar = planar;
  return scene;
}

model::Scene framed(model::Scene scene, bool external) {
  Eigen::Matrix3Xd points(3, 0);
  for (const auto& target : scene.target.points) {
    points.conservativeResize(3, points.cols() + target.cols());
    points.rightCols(target.cols()) = target;
  }
  scene.structure.anchors = geometry::enclosing_frame(geometry::FrameShape::cube, points, 5, false);
  scene.rules.external = external;
  return scene;
}

model::Scene with_symmetry(model::Scene scene) {
  scene.design.symmetry = model::SymmetryUse::detect;
  return scene;
}

}  // namespace

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::string(argv[1]) == "quick";
  std::printf("%-13s %-26s %-22s %10s %10s %7s\n", "part", "problem", "what", "left out/ms",
              "kept/ms", "ratio");
  const model::Scene helix = framed(scene_of({curves::helix(20, 13.2, 1.5, 100)}), true);
  const model::Scene knot = scene_of({curves::torus_knot(2, 5, 25, 10, 150)});
  compare_forward("theta", "trefoil", trefoil(), unequal(trefoil()));
  compare_forward("theta", "(2, 5) knot", knot, unequal(knot));
  compare_forward("theta", "helix in a cube", helix, unequal(helix));
  compare_forward("theta", "trefoil, twisted by a turn", twisted(trefoil()),
                  unequal(twisted(trefoil())));
  compare_forward("z", "two ellipses", planar_ellipses(true), planar_ellipses(false));
  compare_registration(helix);
  geometry::Polyline crooked = model::target_curve(trefoil(), 0);
  for (int i = 0; i < 30; ++i) crooked.points(2, i) += 0.002 * i * (30 - i);
  compare_detection(scene_of({crooked}));
  if (quick) return 0;
  compare_designs("theta", "trefoil", trefoil(), unequal(trefoil()));
  compare_designs("z", "two ellipses", planar_ellipses(true), planar_ellipses(false));
  compare_designs("external", "trefoil in a cube", framed(trefoil(), false),
                  framed(trefoil(), true));
  compare_designs("symmetry", "trefoil", trefoil(), with_symmetry(trefoil()));
  compare_designs("symmetry", "(2, 5) knot", knot, with_symmetry(knot));
}
