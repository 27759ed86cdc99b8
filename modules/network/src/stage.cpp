#include <cmath>
#include <tencer/equilibrium/system.hpp>
#include <tencer/network/stage.hpp>

namespace tencer::network {

std::string describe(Fault fault) {
  switch (fault) {
    case Fault::none:
      return {};
    case Fault::not_checked:
      return "not checked";
    case Fault::idle_cables:
      return "some cables do not pull";
    case Fault::not_finite:
      return "the forces on the rods are not finite";
    case Fault::not_in_equilibrium:
      return "not in equilibrium";
    case Fault::not_stable:
      return "not stable";
  }
  return {};
}

Fault fault_of(const Network& network) {
  if (!idle_cables(network).empty()) return Fault::idle_cables;
  const equilibrium::System system(network.structure);
  const double residual = equilibrium::residual(system, network.state);
  if (!std::isfinite(residual)) return Fault::not_finite;
  if (!(residual < 1e-6)) return Fault::not_in_equilibrium;
  equilibrium::Linearisation at;
  equilibrium::linearise(system, network.state, at);
  return at.regular && at.negative == 0 ? Fault::none : Fault::not_stable;
}

}  // namespace tencer::network
