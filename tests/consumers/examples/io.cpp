#include <iostream>
#include <tencer/io/curve.hpp>

int main() {
  using namespace tencer;
  geometry::Polyline triangle{.points = Eigen::Matrix3Xd::Identity(3, 3), .closed = true};
  if (const auto error = io::write_obj("triangle.obj", {&triangle, 1})) {
    std::cerr << error->text() << '\n';
    return 1;
  }
  const auto curves = io::read_curves("triangle.obj");  // or an error that names file and line
  std::cout << io::obj_text(*curves);
  return curves->front().closed ? 0 : 1;
}
