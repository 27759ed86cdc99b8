#include <algorithm>
#include <tencer/equilibrium/frames.hpp>
#include <tencer/equilibrium/solve.hpp>

namespace tencer::equilibrium {

void relax_frames(const model::Structure& structure, model::State& state) {
  for (std::size_t r = 0; r < state.size(); ++r) {
    if (state[r].theta.size() == 0) continue;
    model::Structure held{.rods = {structure.rods[r]}};
    // Where no vertex moves stretching does nothing but add rounding.
    der::Rod& rod = held.rods[0];
    rod.section.EA = std::min(rod.section.EI1, rod.section.EI2) / (rod.length() * rod.length());
    for (int vertex = 0; vertex < structure.rods[r].vertices(); ++vertex)
      held.pins.push_back({.rod = 0, .vertex = vertex});
    state[r] = solve(System(held), {state[r]}).state[0];
  }
}

}  // namespace tencer::equilibrium
