#include <iostream>
#include <tencer/design.hpp>

int main(int count, char** arguments) {
  const auto curves = tencer::read_curves(count > 1 ? arguments[1] : "knot.obj");
  if (!curves) return std::cerr << curves.error().text() << '\n', 2;
  const auto design = tencer::design(
      *curves, {.section = tencer::round_rod(4e6, 0.1), .max_error = 1.0});  // N/cm^2, cm; %
  if (!design) return std::cerr << design.error().text() << '\n', 2;
  std::cout << design->full_report();
  for (std::size_t i = 0; i < design->built.size(); ++i)
    std::cout << describe(design->structure.cables[i]) << ": " << design->built[i].length
              << " cm\n";
  return design->complete() ? 0 : 3;
}
