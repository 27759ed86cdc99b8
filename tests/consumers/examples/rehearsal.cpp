#include <cmath>
#include <iostream>
#include <tencer/design.hpp>
#include <tencer/rehearsal/actuate.hpp>

int main() {
  using namespace tencer;
  Curve ellipse{.points = Eigen::Matrix3Xd(3, 40), .closed = true};
  for (int i = 0; i < 40; ++i)
    ellipse.points.col(i) << 20 * std::cos(i * 3.14159265 / 20), 12 * std::sin(i * 3.14159265 / 20),
        0;
  const auto design = tencer::design({ellipse});
  if (!design) return std::cerr << design.error().text() << '\n', 2;
  model::ScheduleStep step;
  step.changes.resize(design->built.size());
  step.changes[0] = model::read_length_change("by -10 %");
  const auto found = rehearsal::actuate(*design, {{step}});
  if (!found) return std::cerr << found.error().text() << '\n', 2;
  std::cout << "pulled in by a tenth, the first cable pulls with "
            << found->poses.back().built[0].tension << " N instead of "
            << found->poses.front().built[0].tension << " N\n";
  return found->finished ? 0 : 3;
}
