// The design of a curve file by the front door of C++: same_bytes CURVES DESIGN.
#include <iostream>
#include <tencer/design.hpp>

int main(int count, char** arguments) {
  if (count != 3) return std::cerr << "expected CURVES DESIGN\n", 2;
  const auto design = tencer::design(
      arguments[1], {.max_error = 5, .length_error = 0, .attachment_error = 0, .effort = 1});
  if (!design) return std::cerr << design.error().text() << '\n', 2;
  const auto error = tencer::write_design(arguments[2], *design);
  return error ? (std::cerr << error->text() << '\n', 2) : 0;
}
