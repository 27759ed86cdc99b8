#include <limits>
#include <tencer/der/energy.hpp>

#include "framed_rod.hpp"
#include "reduced.hpp"
#include "uniform_twist.hpp"

namespace tencer::der {

int unknowns(const Rod& rod) {
  const int positions = 3 * rod.vertices();
  switch (twist_model(rod)) {
    case TwistModel::none:
      return positions;
    case TwistModel::uniform:
      return positions + 1;
    case TwistModel::per_edge:
      return positions + rod.edges();
  }
  return positions;
}

std::vector<std::vector<int>> elements(const Rod& rod) {
  const TwistModel model = twist_model(rod);
  const int positions = 3 * rod.vertices();
  std::vector<std::vector<int>> lists;
  const auto add_vertices = [&](std::initializer_list<int> vertices) {
    auto& list = lists.emplace_back();
    for (int v : vertices)
      for (int axis = 0; axis < 3; ++axis) list.push_back(3 * v + axis);
  };
  for (int j = 0; j < rod.edges(); ++j) add_vertices({j, next(rod, j)});
  for (int b = 0; b < rod.bending_vertices(); ++b) {
    const Corner c = corner(rod, b);
    add_vertices({c.before, c.at, c.after});
    if (model == TwistModel::uniform) lists.back().push_back(positions);
    if (model == TwistModel::per_edge)
      lists.back().insert(lists.back().end(),
                          {positions + c.edge_before, positions + c.edge_after});
  }
  return lists;
}

double energy(const Rod& rod, const RodState& state) {
  const Section& s = rod.section;
  const TwistModel model = twist_model(rod);
  double sum = 0;
  for (int j = 0; j < rod.edges(); ++j) {
    const Eigen::Vector3d e = edge(rod, state.x, j);
    if (e.isZero(0)) return std::numeric_limits<double>::infinity();
    sum += stretch_energy<double>(s.EA, rod.rest_lengths[j], e);
  }
  if (model == TwistModel::per_edge) {
    for (int b = 0; b < rod.bending_vertices(); ++b)
      sum += framed_energy(vertex_law(rod, b), framed_vertex(rod, state, b));
    return sum;
  }
  for (int b = 0; b < rod.bending_vertices(); ++b) {
    const Corner c = corner(rod, b);
    sum += bend_energy(s.EI1, c.voronoi, edge(rod, state.x, c.edge_before),
                       edge(rod, state.x, c.edge_after));
  }
  if (model == TwistModel::uniform)
    sum += twisting_moment(rod, state) * uniform_excess(rod, state) / 2;
  return sum;
}

void add_gradient(const Rod& rod, const RodState& state, Eigen::Ref<Eigen::VectorXd> gradient) {
  const Section& s = rod.section;
  const TwistModel model = twist_model(rod);
  const auto at = [&](int vertex) { return gradient.segment<3>(3 * vertex); };
  for (int j = 0; j < rod.edges(); ++j) {
    const Eigen::Vector3d g =
        stretch_gradient<double>(s.EA, rod.rest_lengths[j], edge(rod, state.x, j));
    at(j) -= g;
    at(next(rod, j)) += g;
  }
  const auto add = [&](const Corner& c, const Eigen::Vector3d& e, const Eigen::Vector3d& f) {
    at(c.before) -= e;
    at(c.at) += e - f;
    at(c.after) += f;
  };
  if (model == TwistModel::per_edge) {
    auto theta = gradient.tail(rod.edges());
    for (int b = 0; b < rod.bending_vertices(); ++b) {
      const Corner c = corner(rod, b);
      const auto g = framed_gradient<double>(vertex_law(rod, b), framed_vertex(rod, state, b));
      add(c, g.e, g.f);
      theta[c.edge_before] += g.theta_before;
      theta[c.edge_after] += g.theta_after;
    }
    return;
  }
  for (int b = 0; b < rod.bending_vertices(); ++b) {
    const Corner c = corner(rod, b);
    const auto g = bend_gradient<double>(s.EI1, c.voronoi, edge(rod, state.x, c.edge_before),
                                         edge(rod, state.x, c.edge_after));
    add(c, g.e, g.f);
  }
  if (model == TwistModel::uniform) {
    const double moment = twisting_moment(rod, state);
    for (int b = 0; b < rod.bending_vertices(); ++b) {
      const Corner c = corner(rod, b);
      const auto g = excess_gradient<double>(edge(rod, state.x, c.edge_before),
                                             edge(rod, state.x, c.edge_after));
      add(c, moment * g.e, moment * g.f);
    }
  }
}

Eigen::VectorXd axial_forces(const Rod& rod, const Eigen::Matrix3Xd& x) {
  Eigen::VectorXd forces(rod.edges());
  for (int j = 0; j < rod.edges(); ++j)
    forces[j] = rod.section.EA * (edge(rod, x, j).norm() / rod.rest_lengths[j] - 1);
  return forces;
}

void hessian(const Rod& rod, const RodState& state, const Eigen::VectorXd& axial,
             const ElementSink& sink) {
  const Section& s = rod.section;
  const TwistModel model = twist_model(rod);
  int element = 0;
  Eigen::Matrix<double, 6, 6> stretch;
  for (int j = 0; j < rod.edges(); ++j, ++element) {
    const Eigen::Matrix3d h =
        stretch_hessian(s.EA, rod.rest_lengths[j], axial[j], edge(rod, state.x, j));
    stretch << h, -h, -h, h;
    sink(element, stretch.data());
  }
  const double moment = model == TwistModel::uniform ? twisting_moment(rod, state) : 0.0;
  for (int b = 0; b < rod.bending_vertices(); ++b, ++element) {
    if (model == TwistModel::per_edge) {
      const Eigen::Matrix<double, 11, 11> framed =
          to_vertices<2>(framed_hessian(vertex_law(rod, b), framed_vertex(rod, state, b)));
      sink(element, framed.data());
      continue;
    }
    const Corner c = corner(rod, b);
    const Eigen::Vector3d e = edge(rod, state.x, c.edge_before);
    const Eigen::Vector3d f = edge(rod, state.x, c.edge_after);
    const Eigen::Matrix<double, 6, 6> bend = bend_hessian(s.EI1, c.voronoi, e, f);
    if (model == TwistModel::none) {
      const Eigen::Matrix<double, 9, 9> full = to_vertices<0>(bend);
      sink(element, full.data());
      continue;
    }
    // The energy as max over the moment of moment * excess - moment^2 L / (2 GJ); each vertex
    // carries its share of the last term.
    const auto g = excess_gradient<double>(e, f);
    Eigen::Matrix<double, 7, 7> bordered;
    bordered.topLeftCorner<6, 6>() = bend + moment * excess_hessian(e, f);
    bordered.topRightCorner<6, 1>() << g.e, g.f;
    bordered.bottomLeftCorner<1, 6>() = bordered.topRightCorner<6, 1>().transpose();
    bordered(6, 6) = -c.voronoi / s.GJ;
    const Eigen::Matrix<double, 10, 10> full = to_vertices<1>(bordered);
    sink(element, full.data());
  }
}

}  // namespace tencer::der
