#include "model/gap_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tencer::elimination {
namespace {

using model::CablePass;
using springs::OnRod;

const springs::End& end_of(const springs::Cable& cable, int end) {
  return end == 0 ? cable.a : cable.b;
}

// How points of cables and rods move with the variables of a local model.
class Rates {
 public:
  Rates(const sensitivity::Configuration& at, const LocalModel& local)
      : at_(at), motion_(local.motion), ties_(local.ties) {
    slides_.assign(at.cables().size(), {-1, -1});
    for (int i = 0; i < static_cast<int>(local.parameters.size()); ++i) {
      const auto [kind, cable] = local.parameters[i];
      if (kind == springs::ParameterKind::position_a) slides_[cable][0] = i;
      if (kind == springs::ParameterKind::position_b) slides_[cable][1] = i;
    }
  }

  // Of the arc length of a cable's end.
  Eigen::RowVectorXd slide(int cable, int end) const {
    const int parameter = slides_[cable][end];
    if (parameter < 0) return Eigen::RowVectorXd::Zero(ties_.cols());
    return ties_.row(parameter);
  }

  // Of a place on a rod along a direction.
  Eigen::RowVectorXd place(int rod, int edge, double t, const Eigen::Vector3d& along) const {
    const auto vertices = static_cast<int>(at_.state[rod].x.cols());
    Eigen::RowVectorXd rate = Eigen::RowVectorXd::Zero(ties_.cols());
    for (int axis = 0; axis < 3; ++axis)
      for (const auto& [vertex, weight] :
           {std::pair(edge, 1 - t), std::pair((edge + 1) % vertices, t)})
        if (const int i = at_.system.position_index(rod, vertex, axis); i >= 0)
          rate += along[axis] * weight * motion_.row(i);
    return rate;
  }

  // Of the end of a cable along a direction.
  Eigen::RowVectorXd end(int cable, int end, const Eigen::Vector3d& along) const {
    const auto* on = std::get_if<OnRod>(&end_of(at_.cables()[cable], end));
    if (!on) return Eigen::RowVectorXd::Zero(ties_.cols());
    const auto [edge, t] = at_.system.arc_lengths()[on->rod].locate(on->s);
    return place(on->rod, edge, t, along) + along.dot(tangent(on->rod, edge)) * slide(cable, end);
  }

  // Of a position per arc length at rest.
  Eigen::Vector3d tangent(int rod, int edge) const {
    const auto& x = at_.state[rod].x;
    return (x.col((edge + 1) % x.cols()) - x.col(edge)) /
           at_.system.arc_lengths()[rod].edge_length(edge);
  }

 private:
  const sensitivity::Configuration& at_;
  const Eigen::MatrixXd& motion_;
  Eigen::SparseMatrix<double, Eigen::RowMajor> ties_;
  std::vector<std::array<int, 2>> slides_;  // per cable, the parameters of its ends; -1: none
};

}  // namespace

StepBounds gap_bounds(const sensitivity::Configuration& at, const LocalModel& local,
                      const model::Gaps& gaps) {
  constexpr double near = 3;  // times what is asked for: what is further away does not matter
  const auto& structure = at.system.structure();
  const auto radii = model::outer_radii(structure);
  const Rates rates(at, local);
  std::vector<Eigen::RowVectorXd> rows;
  std::vector<double> lower;
  const auto add = [&](Eigen::RowVectorXd row, double bound) {
    // The tied images of one end cannot move apart.
    if (row.cwiseAbs().maxCoeff() < 1e-12) return;
    rows.push_back(std::move(row));
    lower.push_back(bound);
  };
  const model::CablePasses passes(structure, at.state, gaps);
  for (int c = 0; c < static_cast<int>(at.cables().size()); ++c)
    for (const CablePass& pass : passes.of(at.cables()[c], c, near)) {
      Eigen::RowVectorXd row = (1 - pass.u) * rates.end(c, 0, pass.away) +
                               pass.u * rates.end(c, 1, pass.away) -
                               rates.place(pass.rod, pass.edge, pass.t, pass.away);
      if (pass.beside_end >= 0)
        row -= pass.away.dot(rates.tangent(pass.rod, pass.edge)) * rates.slide(c, pass.beside_end);
      add(std::move(row), std::min(passes.missing(pass), radii[pass.rod]));
    }
  for (const model::MarkPair& pair :
       model::neighbouring_marks(at.cables(), at.system.arc_lengths())) {
    const double asked = gaps.between_marks(radii[pair.rod]);
    if (pair.apart > near * asked) continue;
    const Eigen::RowVectorXd row = rates.slide(pair.second.cable, pair.second.end) -
                                   rates.slide(pair.first.cable, pair.first.end);
    if (pair.apart > asked / 2) {
      add(row, asked - pair.apart);
    } else {
      add(row, -pair.apart);
      add(-row, pair.apart);
    }
  }
  StepBounds bounds{
      .rows = Eigen::MatrixXd(static_cast<Eigen::Index>(rows.size()), local.ties.cols()),
      .lower = Eigen::VectorXd(static_cast<Eigen::Index>(rows.size()))};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    bounds.rows.row(static_cast<Eigen::Index>(i)) = rows[i];
    bounds.lower[static_cast<Eigen::Index>(i)] = lower[i];
  }
  return bounds;
}

double missing_gap(const model::Structure& structure, const model::State& state,
                   const model::Gaps& gaps) {
  constexpr double same = 0.01;  // of the distance asked for: marks are one
  const auto radii = model::outer_radii(structure);
  const model::CablePasses passes(structure, state, gaps);
  double worst = 0;
  for (const auto& cable : structure.cables)
    for (const CablePass& pass : passes.of(cable, 0, 1.0))
      worst = std::max(worst, passes.missing(pass) / radii[pass.rod]);
  for (const model::MarkPair& pair :
       model::neighbouring_marks(structure.cables, arc_lengths(structure))) {
    const double asked = gaps.between_marks(radii[pair.rod]);
    if (pair.apart > same * asked) worst = std::max(worst, (asked - pair.apart) / radii[pair.rod]);
  }
  return worst;
}

}  // namespace tencer::elimination
