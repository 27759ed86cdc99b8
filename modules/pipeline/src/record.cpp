#include "record.hpp"

#include <algorithm>
#include <range/v3/view/zip.hpp>
#include <tencer/certify/tolerance.hpp>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/model/build.hpp>
#include <tencer/model/frames.hpp>
#include <tencer/model/units.hpp>
#include <tencer/network/network.hpp>
#include <tencer/sensitivity/distance.hpp>

namespace tencer::pipeline {
namespace {

// Certificate::off_by_errors.
std::optional<double> off_by_errors(const Solved& solved, const model::Scaling& scaling,
                                    const std::string& length_unit) {
  if (!std::ranges::count(model::length_units(), length_unit)) return std::nullopt;
  const auto response = certify::pose_response(solved.structure, solved.state, solved.tensions,
                                               sensitivity::views_at(solved.target, solved.state));
  if (!response.computed || response.parameters.empty()) return std::nullopt;
  const double millimetre = 1e-3 / model::metres(length_unit) / scaling.scale.length;
  return scaling.scale.length *
         certify::typical_deviation(response,
                                    {.length = model::usual_length_error_mm * millimetre,
                                     .attachment = model::usual_attachment_error_mm * millimetre});
}

}  // namespace

void record(const Solved& solved, const model::Scaling& scaling, model::Design& design) {
  const auto& [structure, state, tensions, target] = solved;
  const auto deviation = sensitivity::deviation(target, state);
  const Eigen::Matrix3d back = deviation.motion.rotation.transpose();
  for (std::size_t r = 0; r < state.size(); ++r) {
    design.pose[r] = scaling.unscaled(back * (state[r].x.colwise() - deviation.motion.translation));
    design.pose_directors[r] = back * model::directors(state[r]);
  }
  const auto assessment = equilibrium::assess(structure, state, tensions);
  const Eigen::VectorXd lengths = network::cable_lengths({structure, state});
  design.built.resize(structure.cables.size());
  for (auto&& [built, length, tension] :
       ranges::views::zip(design.built, lengths, assessment.tensions))
    built = {.length = length * scaling.scale.length, .tension = tension * scaling.scale.force()};
  design.strains = model::largest_bending_strains(structure, state);
  for (auto& strain : design.strains)
    if (strain) strain = model::unscaled(*strain, scaling.scale.length);
  design.error = {.max_percent = deviation.max_percent, .rms_percent = deviation.rms_percent};
  design.certificate = assessment.certificate();
  if (assessment.certified())
    design.certificate->off_by_errors = off_by_errors(solved, scaling, design.length_unit);
}

}  // namespace tencer::pipeline
