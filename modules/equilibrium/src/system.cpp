#include <algorithm>
#include <tencer/der/energy.hpp>
#include <tencer/equilibrium/system.hpp>
#include <tencer/springs/law.hpp>
#include <utility>

namespace tencer::equilibrium {
namespace {

// Marks the held unknowns of every rod and numbers the others.
std::vector<std::vector<int>> number_unknowns(const model::Structure& structure, int& size) {
  std::vector<std::vector<int>> index;
  for (const auto& rod : structure.rods) {
    auto& held = index.emplace_back(der::unknowns(rod), 0);
    if (structure.planar)
      for (int v = 0; v < rod.vertices(); ++v) held[3 * v + 2] = -1;
    const int theta = 3 * rod.vertices();
    if (rod.clamp_start_frame && static_cast<int>(held.size()) > theta) held[theta] = -1;
    if (rod.clamp_end_frame && static_cast<int>(held.size()) > theta)
      held[theta + rod.edges() - 1] = -1;
  }
  for (const model::Pin& pin : structure.pins)
    for (int axis = 0; axis < 3; ++axis)
      if (pin.axes[axis]) index[pin.rod][3 * pin.vertex + axis] = -1;
  size = 0;
  for (auto& rod : index)
    for (int& i : rod)
      if (i == 0) i = size++;
  return index;
}

// Loads as forces on vertices: half of each edge's share, and the shares of the ends of the edge
// that a point is on.
std::vector<Eigen::Matrix3Xd> vertex_loads(const model::Structure& structure,
                                           const std::vector<geometry::ArcLength>& arc_lengths) {
  std::vector<Eigen::Matrix3Xd> loads;
  if (structure.point_loads.empty() && structure.line_loads.empty()) return loads;
  for (const auto& rod : structure.rods) loads.push_back(Eigen::Matrix3Xd::Zero(3, rod.vertices()));
  const auto add = [&](int rod, int edge, double t, const Eigen::Vector3d& force) {
    loads[rod].col(edge) += (1 - t) * force;
    loads[rod].col((edge + 1) % structure.rods[rod].vertices()) += t * force;
  };
  for (const model::LineLoad& load : structure.line_loads)
    for (int j = 0; j < structure.rods[load.rod].edges(); ++j)
      add(load.rod, j, 0.5, structure.rods[load.rod].rest_lengths[j] * load.force_per_length);
  for (const model::PointLoad& load : structure.point_loads) {
    const auto at = arc_lengths[load.rod].locate(load.s);
    add(load.rod, at.edge, at.t, load.force);
  }
  return loads;
}

std::vector<int> stencil_unknowns(const springs::Stencil& stencil,
                                  const std::vector<std::vector<int>>& index) {
  std::vector<int> list;
  for (int i = 0; i < stencil.count; ++i)
    for (int axis = 0; axis < 3; ++axis)
      list.push_back(index[stencil.shares[i].rod][3 * stencil.shares[i].vertex + axis]);
  return list;
}

bool same_vertices(const springs::Stencil& a, const springs::Stencil& b) {
  if (a.count != b.count) return false;
  for (int i = 0; i < a.count; ++i)
    if (a.shares[i].rod != b.shares[i].rod || a.shares[i].vertex != b.shares[i].vertex)
      return false;
  return true;
}

}  // namespace

System::System(model::Structure structure, geometry::Side side)
    : structure_(std::move(structure)), side_(side) {
  validate(structure_);
  for (const auto& rod : structure_.rods) arc_lengths_.emplace_back(rod.rest_lengths, rod.closed);
  index_ = number_unknowns(structure_, size_);
  vertex_loads_ = vertex_loads(structure_, arc_lengths_);
  if (!vertex_loads_.empty()) load_gradient_ = Eigen::VectorXd::Zero(size_);
  for (std::size_t r = 0; r < vertex_loads_.size(); ++r)
    for (Eigen::Index i = 0; i < vertex_loads_[r].size(); ++i)
      if (index_[r][i] >= 0) load_gradient_[index_[r][i]] = -vertex_loads_[r].data()[i];
  for (std::size_t r = 0; r < structure_.rods.size(); ++r) {
    if (der::twist_model(structure_.rods[r]) == der::TwistModel::uniform) ++saddle_unknowns_;
    for (auto& element : der::elements(structure_.rods[r])) {
      for (int& unknown : element) unknown = index_[r][unknown];
      elements_.push_back(std::move(element));
    }
  }
  rod_elements_ = elements_.size();
  for (const auto& cable : structure_.cables)
    stencils_.push_back(springs::stencil(cable, arc_lengths_, structure_.anchors, side_));
  lay_out();
}

void System::set_cables(std::vector<springs::Cable> cables) {
  const int rods = static_cast<int>(structure_.rods.size());
  for (const auto& cable : cables)
    springs::validate(cable, rods, static_cast<int>(structure_.anchors.cols()));
  structure_.cables = std::move(cables);
  std::vector<springs::Stencil> stencils;
  for (const auto& cable : structure_.cables)
    stencils.push_back(springs::stencil(cable, arc_lengths_, structure_.anchors, side_));
  const bool same = std::ranges::equal(stencils, stencils_, same_vertices);
  stencils_ = std::move(stencils);
  if (!same) lay_out();
}

void System::lay_out() {
  component_of_rod_ = model::components(structure_);
  const int component_count = 1 + *std::ranges::max_element(component_of_rod_);
  std::vector<int> longest(component_count, -1);
  for (int r = 0; r < static_cast<int>(structure_.rods.size()); ++r) {
    int& best = longest[component_of_rod_[r]];
    if (best < 0 || structure_.rods[r].length() > structure_.rods[best].length()) best = r;
  }
  // The others count when the longest is straight and does not show a turn about itself.
  stabilising_unknowns_.assign(component_count, {});
  for (int rod = 0; rod < static_cast<int>(structure_.rods.size()); ++rod) {
    const int component = component_of_rod_[rod];
    const int n = structure_.rods[rod].vertices();
    const int gaps = structure_.rods[rod].closed ? 4 : 3;
    int last = -1;
    for (int k = 0; k < 4; k += rod == longest[component] ? 1 : 2) {
      const int vertex = std::min(n - 1, k * n / gaps);
      if (vertex == last) continue;
      last = vertex;
      for (int axis = 0; axis < 3; ++axis)
        if (position_index(rod, vertex, axis) >= 0)
          stabilising_unknowns_[component].push_back(position_index(rod, vertex, axis));
    }
    // A straight rod with frames turns about itself without moving a vertex.
    if (rod == longest[component] &&
        der::twist_model(structure_.rods[rod]) == der::TwistModel::per_edge)
      if (const int theta = index(rod, 3 * n + structure_.rods[rod].edges() / 2); theta >= 0)
        stabilising_unknowns_[component].push_back(theta);
  }

  elements_.resize(rod_elements_);
  for (const auto& stencil : stencils_) elements_.push_back(stencil_unknowns(stencil, index_));
  elements_.insert(elements_.end(), stabilising_unknowns_.begin(), stabilising_unknowns_.end());
  assembler_ = std::make_unique<linalg::SymmetricAssembler>(size_, elements_);
}

double System::energy(const model::State& state) const {
  double sum = 0;
  for (std::size_t r = 0; r < state.size(); ++r) sum += der::energy(structure_.rods[r], state[r]);
  for (std::size_t c = 0; c < stencils_.size(); ++c)
    sum += springs::energy(structure_.cables[c], model::span_of(stencils_[c], state).norm());
  for (std::size_t r = 0; r < vertex_loads_.size(); ++r)
    sum -= vertex_loads_[r].cwiseProduct(state[r].x).sum();
  return sum;
}

Eigen::VectorXd System::rod_gradient(const model::State& state) const {
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(size_);
  Eigen::VectorXd local;
  for (std::size_t r = 0; r < state.size(); ++r) {
    local.setZero(static_cast<Eigen::Index>(index_[r].size()));
    der::add_gradient(structure_.rods[r], state[r], local);
    for (Eigen::Index i = 0; i < local.size(); ++i)
      if (index_[r][i] >= 0) gradient[index_[r][i]] += local[i];
  }
  if (load_gradient_.size() > 0) gradient += load_gradient_;
  return gradient;
}

Eigen::VectorXd System::gradient(const model::State& state) const {
  Eigen::VectorXd gradient = rod_gradient(state);
  add_cable_gradient(state, gradient);
  return gradient;
}

void System::add_cable_gradient(const model::State& state, Eigen::VectorXd& gradient) const {
  for (std::size_t c = 0; c < stencils_.size(); ++c) {
    const auto& stencil = stencils_[c];
    const Eigen::Vector3d force =
        springs::force(structure_.cables[c], model::span_of(stencil, state));
    for_each_unknown(
        stencil, [&](int at, int axis, double weight) { gradient[at] += weight * force[axis]; });
  }
}

InternalForces System::internal_forces(const model::State& state) const {
  InternalForces forces;
  for (std::size_t r = 0; r < state.size(); ++r)
    forces.axial.push_back(der::axial_forces(structure_.rods[r], state[r].x));
  forces.tension.resize(static_cast<Eigen::Index>(stencils_.size()));
  for (std::size_t c = 0; c < stencils_.size(); ++c)
    forces.tension[static_cast<Eigen::Index>(c)] =
        springs::tension(structure_.cables[c], model::span_of(stencils_[c], state).norm());
  return forces;
}

void System::hessian(const model::State& state, const InternalForces& forces,
                     linalg::SymmetricMatrix& matrix) const {
  Eigen::Map<Eigen::VectorXd>(matrix.valuePtr(), matrix.nonZeros()).setZero();
  int first = 0;
  for (std::size_t r = 0; r < state.size(); ++r) {
    int count = 0;
    der::hessian(structure_.rods[r], state[r], forces.axial[r],
                 [&](int element, const double* values) {
                   assembler_->add(first + element, values, matrix);
                   ++count;
                 });
    first += count;
  }
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 12, 12> block;
  for (std::size_t c = 0; c < stencils_.size(); ++c) {
    const auto& stencil = stencils_[c];
    const Eigen::Matrix3d stiffness =
        springs::stiffness_matrix(structure_.cables[c], model::span_of(stencil, state),
                                  forces.tension[static_cast<Eigen::Index>(c)]);
    block.resize(3 * stencil.count, 3 * stencil.count);
    for (int i = 0; i < stencil.count; ++i)
      for (int j = 0; j < stencil.count; ++j)
        block.block<3, 3>(3 * i, 3 * j) =
            stencil.shares[i].weight * stencil.shares[j].weight * stiffness;
    assembler_->add(first++, block.data(), matrix);
  }
}

void System::add_stabilising(int component, const Eigen::MatrixXd& stabilising,
                             linalg::SymmetricMatrix& matrix) const {
  const int first = static_cast<int>(rod_elements_ + stencils_.size());
  assembler_->add(first + component, stabilising.data(), matrix);
}

void System::displace(model::State& state, const Eigen::VectorXd& step) const {
  Eigen::VectorXd local;
  for (std::size_t r = 0; r < state.size(); ++r) {
    local.resize(static_cast<Eigen::Index>(index_[r].size()));
    for (Eigen::Index i = 0; i < local.size(); ++i)
      local[i] = index_[r][i] >= 0 ? step[index_[r][i]] : 0.0;
    der::displace(structure_.rods[r], state[r], local);
  }
}

model::State System::displaced(const model::State& state, const Eigen::VectorXd& step) const {
  model::State result = state;
  displace(result, step);
  return result;
}

}  // namespace tencer::equilibrium
