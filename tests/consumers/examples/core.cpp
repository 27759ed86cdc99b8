#include <iostream>
#include <tencer/core/error.hpp>

// A value, or the error that prevented it.
tencer::core::Expected<double> half(double x) {
  if (x < 0) return tencer::core::Error{"half", "expected a number that is not negative"};
  return x / 2;
}

int main() {
  std::cout << *half(3) << '\n' << half(-1).error().text() << '\n';
  return half(3).value() == 1.5 ? 0 : 1;
}
