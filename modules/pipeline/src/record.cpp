#include "record.hpp"

#include <range/v3/view/zip.hpp>
#include <span>
#include <utility>

#include "frames.hpp"

namespace tencer::pipeline {

sensitivity::Target target_of(const equilibrium::Structure& structure,
                              std::vector<Eigen::Matrix3Xd> points,
                              std::vector<Eigen::VectorXd> weights) {
  sensitivity::Target target = sensitivity::make_target(structure, std::move(points));
  target.weights = std::move(weights);
  return target;
}

void record(const equilibrium::Structure& structure, const equilibrium::State& state,
            const Eigen::VectorXd& tensions, const sensitivity::Target& target, const Units& units,
            io::Design& design) {
  const auto deviation = sensitivity::deviation(target, state);
  const Eigen::Matrix3d back = deviation.motion.rotation.transpose();
  for (auto&& [rod, rod_state] : ranges::views::zip(design.rods, state)) {
    rod.pose = units.unscaled(back * (rod_state.x.colwise() - deviation.motion.translation));
    rod.pose_directors = back * directors(rod_state);
  }

  const equilibrium::Certificate certificate = equilibrium::certify(structure, state, tensions);
  const equilibrium::System system(structure);
  const std::span taut(certificate.tensions.data(), structure.cables.size());
  for (auto&& [cable, stencil, tension] :
       ranges::views::zip(design.cables, system.stencils(), taut)) {
    cable.length = equilibrium::span_of(stencil, state).norm() * units.scale.length;
    cable.tension = tension * units.scale.force();
  }
  design.error = {.max_percent = deviation.max_percent, .rms_percent = deviation.rms_percent};
  design.certificate =
      io::Certificate{.residual = certificate.residual,
                      .smallest_eigenvalue = certificate.stability.smallest_eigenvalue,
                      .eigenvalue_unit = "max EI / L^4, one unit of mass per length",
                      .slack_cables = static_cast<int>(certificate.slack.size()),
                      .stable = certificate.stands()};
}

}  // namespace tencer::pipeline
