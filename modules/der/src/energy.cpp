#include <tencer/core/error.hpp>
#include <tencer/der/energy.hpp>

#include "hyper_dual.hpp"
#include "reduced.hpp"

namespace tencer::der {
namespace {

int next(const Rod& rod, int vertex) { return vertex + 1 < rod.vertices() ? vertex + 1 : 0; }
int previous(const Rod& rod, int vertex) { return vertex > 0 ? vertex - 1 : rod.vertices() - 1; }

Eigen::Vector3d edge(const Rod& rod, const Eigen::Matrix3Xd& x, int j) {
  return x.col(next(rod, j)) - x.col(j);
}

// The three vertices and two edges at a bending vertex, and its Voronoi length.
struct Corner {
  int before, at, after;        // vertices
  int edge_before, edge_after;  // edges
  double voronoi;
};

Corner corner(const Rod& rod, int b) {
  const int at = rod.bending_vertex(b);
  const int before = previous(rod, at);
  return {before, at, next(rod, at),
          before, at, (rod.rest_lengths[before] + rod.rest_lengths[at]) / 2};
}

// d(e, f)/d(x_before, x_at, x_after) applied from both sides to a 6 x 6 edge Hessian.
Eigen::Matrix<double, 9, 9> to_vertices(const Eigen::Matrix<double, 6, 6>& h) {
  Eigen::Matrix<double, 9, 6> half;  // rows: vertices
  half.topRows<3>() = -h.topRows<3>();
  half.middleRows<3>(3) = h.topRows<3>() - h.bottomRows<3>();
  half.bottomRows<3>() = h.bottomRows<3>();
  Eigen::Matrix<double, 9, 9> full;
  full.leftCols<3>() = -half.leftCols<3>();
  full.middleCols<3>(3) = half.leftCols<3>() - half.rightCols<3>();
  full.rightCols<3>() = half.rightCols<3>();
  return full;
}

}  // namespace

int unknowns(const Rod& rod) { return 3 * rod.vertices(); }

std::vector<std::vector<int>> elements(const Rod& rod) {
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
  }
  return lists;
}

RodState make_state(const Rod& rod, Eigen::Matrix3Xd x) {
  core::require(x.cols() == rod.vertices(), "make_state: needs one point per vertex");
  return {.x = std::move(x)};
}

double energy(const Rod& rod, const RodState& state) {
  const Section& s = rod.section;
  double sum = 0;
  for (int j = 0; j < rod.edges(); ++j)
    sum += stretch_energy<double>(s.EA, rod.rest_lengths[j], edge(rod, state.x, j));
  for (int b = 0; b < rod.bending_vertices(); ++b) {
    const Corner c = corner(rod, b);
    sum += bend_energy(s.EI1, c.voronoi, edge(rod, state.x, c.edge_before),
                       edge(rod, state.x, c.edge_after));
  }
  return sum;
}

void add_gradient(const Rod& rod, const RodState& state, Eigen::Ref<Eigen::VectorXd> gradient) {
  const Section& s = rod.section;
  const auto at = [&](int vertex) { return gradient.segment<3>(3 * vertex); };
  for (int j = 0; j < rod.edges(); ++j) {
    const Eigen::Vector3d g =
        stretch_gradient<double>(s.EA, rod.rest_lengths[j], edge(rod, state.x, j));
    at(j) -= g;
    at(next(rod, j)) += g;
  }
  for (int b = 0; b < rod.bending_vertices(); ++b) {
    const Corner c = corner(rod, b);
    const auto g = bend_gradient<double>(s.EI1, c.voronoi, edge(rod, state.x, c.edge_before),
                                         edge(rod, state.x, c.edge_after));
    at(c.before) -= g.e;
    at(c.at) += g.e - g.f;
    at(c.after) += g.f;
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
  int element = 0;
  Eigen::Matrix<double, 6, 6> stretch;
  for (int j = 0; j < rod.edges(); ++j, ++element) {
    const Eigen::Matrix3d h =
        stretch_hessian(s.EA, rod.rest_lengths[j], axial[j], edge(rod, state.x, j));
    stretch << h, -h, -h, h;
    sink(element, stretch.data());
  }
  for (int b = 0; b < rod.bending_vertices(); ++b, ++element) {
    const Corner c = corner(rod, b);
    const Eigen::Matrix<double, 9, 9> bend = to_vertices(bend_hessian(
        s.EI1, c.voronoi, edge(rod, state.x, c.edge_before), edge(rod, state.x, c.edge_after)));
    sink(element, bend.data());
  }
}

Eigen::VectorXd third_derivative(const Rod& rod, const RodState& state, const Eigen::VectorXd& v,
                                 const Eigen::VectorXd& w) {
  const Section& s = rod.section;
  const auto along = [&](int j) {
    return hyper_dual_vector(edge(rod, state.x, j),
                             v.segment<3>(3 * next(rod, j)) - v.segment<3>(3 * j),
                             w.segment<3>(3 * next(rod, j)) - w.segment<3>(3 * j));
  };
  Eigen::VectorXd result = Eigen::VectorXd::Zero(unknowns(rod));
  const auto at = [&](int vertex) { return result.segment<3>(3 * vertex); };
  for (int j = 0; j < rod.edges(); ++j) {
    const Eigen::Vector3d g =
        mixed_part(stretch_gradient<HyperDual>(s.EA, rod.rest_lengths[j], along(j)));
    at(j) -= g;
    at(next(rod, j)) += g;
  }
  for (int b = 0; b < rod.bending_vertices(); ++b) {
    const Corner c = corner(rod, b);
    const auto g =
        bend_gradient<HyperDual>(s.EI1, c.voronoi, along(c.edge_before), along(c.edge_after));
    const Eigen::Vector3d e = mixed_part(g.e);
    const Eigen::Vector3d f = mixed_part(g.f);
    at(c.before) -= e;
    at(c.at) += e - f;
    at(c.after) += f;
  }
  return result;
}

void displace(const Rod& rod, RodState& state, const Eigen::Ref<const Eigen::VectorXd>& step) {
  state.x.reshaped() += step.head(3 * rod.vertices());
}

}  // namespace tencer::der
