// Whether the same shape gets the same number of cables: designs of curves as they are, moved,
// turned, reversed, their vertices renumbered, shaken by 1e-9 and by 1e-4 of their size.
//
// Usage: bench_steadiness VARIATIONS CURVE...   (so many variations, split among the six kinds)
#include <Eigen/Geometry>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <tencer/design.hpp>
#include <tencer/geometry/measure.hpp>
#include <tencer/io/scene.hpp>

using namespace tencer;

namespace {

using Curves = std::vector<Curve>;
using Random = std::mt19937_64;

double uniform(Random& random, double most) {
  return std::uniform_real_distribution<double>(-most, most)(random);
}

Eigen::Vector3d anywhere(Random& random, double most) {
  return {uniform(random, most), uniform(random, most), uniform(random, most)};
}

Curves moved(Curves curves, double size, Random& random) {
  const Eigen::Vector3d by = anywhere(random, 3 * size);
  for (Curve& curve : curves) curve.points.colwise() += by;
  return curves;
}

Curves turned(Curves curves, double, Random& random) {
  const Eigen::Matrix3d by =
      Eigen::AngleAxisd(uniform(random, 3.0), anywhere(random, 1).normalized()).toRotationMatrix();
  for (Curve& curve : curves) curve.points = by * curve.points;
  return curves;
}

Curves reversed(Curves curves, double, Random&) {
  for (Curve& curve : curves) curve.points = curve.points.rowwise().reverse().eval();
  return curves;
}

Curves renumbered(Curves curves, double, Random& random) {
  for (Curve& curve : curves) {
    if (!curve.closed) continue;
    const int n = curve.vertices();
    const int first = std::uniform_int_distribution<int>(1, n - 1)(random);
    const Eigen::Matrix3Xd before = curve.points;
    for (int i = 0; i < n; ++i) curve.points.col(i) = before.col((i + first) % n);
  }
  return curves;
}

Curves shaken(Curves curves, double most, Random& random) {
  for (Curve& curve : curves)
    for (auto point : curve.points.colwise()) point += anywhere(random, most);
  return curves;
}

Curves shaken_hardly(Curves curves, double size, Random& random) {
  return shaken(std::move(curves), 1e-9 * size, random);
}
Curves shaken_a_little(Curves curves, double size, Random& random) {
  return shaken(std::move(curves), 1e-4 * size, random);
}

struct Kind {
  const char* name;
  Curves (*vary)(Curves, double, Random&);
};

constexpr Kind kinds[] = {{"moved", moved},
                          {"turned", turned},
                          {"reversed", reversed},
                          {"renumbered", renumbered},
                          {"shaken 1e-9", shaken_hardly},
                          {"shaken 1e-4", shaken_a_little}};

// The cables of the curves' design whose error allowed is `allowed`, a length: a box about a curve
// that was turned has another diagonal.
std::string cables_of(const Curves& curves, const std::string& source, double allowed) {
  auto scene = io::scene_of_curves(curves, source);
  if (!scene) return scene.error().text();
  scene->design.max_error = 100 * allowed / geometry::bounding_box_diagonal(curves);
  const auto design = pipeline::design(*scene);
  if (!design) return design.error().text();
  return std::to_string(design->built.size()) + (design->complete() ? "" : "!");
}

}  // namespace

int main(int argc, char** argv) {
  const int variations = argc > 2 ? std::atoi(argv[1]) : 0;
  if (variations < 1) {
    std::fprintf(stderr, "usage: bench_steadiness VARIATIONS CURVE...\n");
    return 2;
  }
  std::printf("number of cables of each variation; !: not complete\n");
  for (int i = 2; i < argc; ++i) {
    const auto scene = read_scene(argv[i]);
    if (!scene) {
      std::fprintf(stderr, "%s\n", scene.error().text().c_str());
      return 2;
    }
    const Curves curves = model::target_curves(*scene);
    const double size = geometry::bounding_box_diagonal(curves);
    const double allowed = 0.01 * size;
    std::printf("%s\n  as it is     %s\n", argv[i], cables_of(curves, argv[i], allowed).c_str());
    Random random(1);
    std::map<int, std::string> rows;
    for (int v = 0; v < variations; ++v) {
      const int kind = v % static_cast<int>(std::size(kinds));
      const std::string cables =
          cables_of(kinds[kind].vary(curves, size, random), argv[i], allowed);
      rows[kind] += " " + cables;
    }
    for (const auto& [kind, row] : rows) std::printf("  %-12s%s\n", kinds[kind].name, row.c_str());
    std::fflush(stdout);
  }
}
