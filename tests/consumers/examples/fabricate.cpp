#include <iostream>
#include <tencer/fabricate/cut_list.hpp>
#include <tencer/fabricate/names.hpp>

int main() {
  using namespace tencer;
  model::Design ring{.length_unit = "cm"};
  ring.structure.rods = {{.closed = true,
                          .section = {.shape = der::Circle{0.1}},
                          .rest_lengths = Eigen::VectorXd::Constant(6, 10)}};
  ring.structure.cables = {{.a = springs::OnRod{0, 5}, .b = springs::OnRod{0, 35}}};
  ring.built = {{.length = 16, .tension = 2}};
  const fabricate::CutList list = fabricate::cut_list(ring, {.joint = 20, .knot = 50});  // mm
  for (const fabricate::CableCut& cable : list.cables)
    std::cout << fabricate::end_name(cable.a) << " to " << fabricate::end_name(cable.b) << ": "
              << fabricate::tenths(cable.cut) << " mm\n";
  return list.rods[0].cut == 620 ? 0 : 1;
}
