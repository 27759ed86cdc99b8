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
#include <tencer/io/scene.hpp>
#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/prepare.hpp>
#include <tencer/sparsify/balance.hpp>
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

io::Scene scene_of(std::vector<geometry::Polyline> curves) {
  auto scene = io::scene_of_curves(std::move(curves), "bench.obj");
  if (!scene) throw std::runtime_error(scene.error().text());
  return *std::move(scene);
}

io::Scene trefoil() {
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
  pipeline::Prepared prepared;
  sparsify::Network network;
};

Held held(const io::Scene& scene) {
  auto prepared = pipeline::prepare(scene);
  if (!prepared) throw std::runtime_error(prepared.error().text());
  const auto candidates =
      sparsify::candidates(prepared->structure, prepared->target.points, prepared->rules);
  if (!candidates) throw std::runtime_error(candidates.error().text());
  auto result = sparsify::balance({prepared->structure, prepared->start}, prepared->target,
                                  *candidates, nullptr);
  return {std::move(*prepared), std::move(result.network)};
}

// The same cables on both scenes' rods: one factorisation, and the equilibrium from the target.
void compare_forward(const char* part, const char* problem, const io::Scene& left_out,
                     const io::Scene& kept) {
  const Held with = held(left_out);
  auto other = pipeline::prepare(kept);
  if (!other) throw std::runtime_error(other.error().text());
  equilibrium::Structure structure = other->structure;
  structure.cables = with.network.structure.cables;
  const equilibrium::System small(with.network.structure);
  const equilibrium::System large(structure);
  const auto linearise = [](const equilibrium::System& system, const equilibrium::State& state) {
    equilibrium::Linearisation at;
    equilibrium::linearise(system, state, at);
    return median_seconds([&] { equilibrium::linearise(system, state, at); });
  };
  const std::string unknowns =
      std::to_string(small.size()) + " and " + std::to_string(large.size()) + " unknowns";
  print(part, problem, "Hessian and its factor", linearise(small, with.prepared.start),
        linearise(large, other->start), unknowns);
  equilibrium::Equilibrium a, b;
  const double small_seconds =
      median_seconds([&] { a = equilibrium::solve(small, with.prepared.start); });
  const double large_seconds = median_seconds([&] { b = equilibrium::solve(large, other->start); });
  // Where nothing holds them in space, solutions may lie differently there.
  sensitivity::Target there{.align = with.prepared.target.align};
  for (const auto& rod : b.state) there.points.push_back(rod.x);
  const double apart = sensitivity::deviation(there, a.state).max;
  char note[120];
  std::snprintf(note, sizeof note, "%d and %d iterations, %.0e L apart%s", a.iterations,
                b.iterations, apart, a.usable() && b.usable() ? "" : ", NOT USABLE");
  print(part, problem, "equilibrium", small_seconds, large_seconds, note);
}

void compare_designs(const char* part, const char* problem, const io::Scene& left_out,
                     const io::Scene& kept) {
  std::string note;
  const auto design = [&](const io::Scene& scene) {
    return seconds_of([&] {
      const auto result = pipeline::design(scene);
      note += note.empty() ? "" : " and ";
      note += result ? std::to_string(result->cables.size()) : result.error().text();
    });
  };
  const double a = design(left_out);
  const double b = design(kept);
  print(part, problem, "design", a, b, note + " cables");
}

// The distance of an equilibrium to the target and its rates of change with 50 parameters.
void compare_registration(const io::Scene& scene) {
  const Held anchored = held(scene);
  const equilibrium::System system(anchored.network.structure);
  const Eigen::MatrixXd rates = Eigen::MatrixXd::Random(system.size(), 50);
  const auto distance = [&](bool align) {
    sensitivity::Target target = anchored.prepared.target;
    target.align = align;
    return median_seconds([&] {
      const sensitivity::Distance at(target, system, anchored.network.state);
      if (at.residual_rates(rates).size() == 0) std::abort();
    });
  };
  print("registration", "helix in a cube", "distance and its rates", distance(false),
        distance(true), "");
}

void compare_detection(const io::Scene& without) {
  io::Scene with = without;
  with.design.symmetry = "detect";
  const auto prepare = [](const io::Scene& scene) {
    return median_seconds([&] {
      if (!pipeline::prepare(scene)) std::abort();
    });
  };
  print("symmetry", "a knot that has none", "preparation", prepare(without), prepare(with), "");
}

io::Scene unequal(io::Scene scene) {
  for (auto& rod : scene.rods) rod.section.EI[1] *= 1 + 1e-6;
  return scene;
}

io::Scene twisted(io::Scene scene) {
  scene.rods[0].closing_angle = 6.283185307179586;
  return scene;
}

io::Scene planar_ellipses(bool planar) {
  geometry::Polyline inner = curves::ellipse(15, 6, 60);
  io::Scene scene = scene_of({curves::ellipse(32.5, 22, 100), inner});
  scene.planar = planar;
  return scene;
}

io::Scene framed(io::Scene scene, bool external) {
  Eigen::Matrix3Xd points(3, 0);
  for (const auto& rod : scene.rods) {
    const Eigen::Index before = points.cols();
    points.conservativeResize(3, before + rod.target.points.cols());
    points.rightCols(rod.target.points.cols()) = rod.target.points;
  }
  scene.anchors = geometry::enclosing_frame(geometry::FrameShape::cube, points, 5, false);
  scene.design.external = external;
  return scene;
}

io::Scene with_symmetry(io::Scene scene) {
  scene.design.symmetry = "detect";
  return scene;
}

}  // namespace

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::string(argv[1]) == "quick";
  std::printf("%-13s %-26s %-22s %10s %10s %7s\n", "part", "problem", "what", "left out/ms",
              "kept/ms", "ratio");
  const io::Scene helix = framed(scene_of({curves::helix(20, 13.2, 1.5, 100)}), true);
  const io::Scene knot = scene_of({curves::torus_knot(2, 5, 25, 10, 150)});
  compare_forward("theta", "trefoil", trefoil(), unequal(trefoil()));
  compare_forward("theta", "(2, 5) knot", knot, unequal(knot));
  compare_forward("theta", "helix in a cube", helix, unequal(helix));
  compare_forward("theta", "trefoil, twisted by a turn", twisted(trefoil()),
                  unequal(twisted(trefoil())));
  compare_forward("z", "two ellipses", planar_ellipses(true), planar_ellipses(false));
  compare_registration(helix);
  io::Scene crooked = trefoil();
  for (int i = 0; i < 30; ++i) crooked.rods[0].target.points(2, i) += 0.002 * i * (30 - i);
  compare_detection(crooked);
  if (quick) return 0;
  compare_designs("theta", "trefoil", trefoil(), unequal(trefoil()));
  compare_designs("z", "two ellipses", planar_ellipses(true), planar_ellipses(false));
  compare_designs("external", "trefoil in a cube", framed(trefoil(), false),
                  framed(trefoil(), true));
  compare_designs("symmetry", "trefoil", trefoil(), with_symmetry(trefoil()));
  compare_designs("symmetry", "(2, 5) knot", knot, with_symmetry(knot));
}
