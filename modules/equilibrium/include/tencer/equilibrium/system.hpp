// A structure's energy and derivatives as functions of its free unknowns.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <tencer/linalg/symmetric_assembler.hpp>
#include <tencer/model/state.hpp>
#include <vector>

namespace tencer::equilibrium {

// The forces along edges and cables; tension positive.
struct InternalForces {
  std::vector<Eigen::VectorXd> axial{};  // per rod, per edge
  Eigen::VectorXd tension{};             // per cable
};

// Which unknowns are free and how the Hessian is laid out, worked out once for a structure. The
// free unknowns are the rods' own (der::unknowns) in order, less pinned coordinates, z of a planar
// structure and clamped frames.
class System {
 public:
  // Validates the structure. Attachments exactly at a vertex belong to the edge on `side`.
  explicit System(model::Structure structure, geometry::Side side = geometry::Side::after);

  const model::Structure& structure() const { return structure_; }
  const std::vector<springs::Stencil>& stencils() const { return stencils_; }
  const std::vector<geometry::ArcLength>& arc_lengths() const { return arc_lengths_; }
  int size() const { return size_; }

  // Replaces the cables. The Hessian's pattern is worked out again only when an attachment moved to
  // another edge or the number of cables changed.
  void set_cables(std::vector<springs::Cable> cables);

  // Free index of a rod's own unknown, -1 when it is held.
  int index(int rod, int unknown) const { return index_[rod][unknown]; }
  int position_index(int rod, int vertex, int axis) const { return index(rod, 3 * vertex + axis); }

  // Calls visit(unknown, axis, weight) for the free coordinates of the vertices that share in a
  // span: a force f along it acts on each with weight * f[axis].
  template <class Visit>
  void for_each_unknown(const springs::Stencil& stencil, Visit&& visit) const {
    for (int i = 0; i < stencil.count; ++i) {
      const springs::Share& share = stencil.shares[i];
      for (int axis = 0; axis < 3; ++axis)
        if (const int at = position_index(share.rod, share.vertex, axis); at >= 0)
          visit(at, axis, share.weight);
    }
  }

  // Unknowns that are stationary maxima by construction (twisting moments of uniform rods): so many
  // negative pivots belong to a stable state.
  int saddle_unknowns() const { return saddle_unknowns_; }

  double energy(const model::State& state) const;
  Eigen::VectorXd gradient(const model::State& state) const;
  // Its two parts: of the rods and the loads on them, which is what cables have to balance, and of
  // the cables.
  Eigen::VectorXd rod_gradient(const model::State& state) const;
  void add_cable_gradient(const model::State& state, Eigen::VectorXd& gradient) const;

  // The part of rod_gradient that loads have, the same at every state; empty without loads.
  const Eigen::VectorXd& load_gradient() const { return load_gradient_; }

  // Writes the Hessian into `matrix` (a copy of pattern()). `forces`: those in the geometric
  // stiffness, see der::hessian; internal_forces(state) gives the Hessian itself. The
  // rank-deficient directions of rigid motion are left as they are.
  const linalg::SymmetricMatrix& pattern() const { return assembler_->pattern(); }
  void hessian(const model::State& state, const InternalForces& forces,
               linalg::SymmetricMatrix& matrix) const;
  InternalForces internal_forces(const model::State& state) const;

  // For rigid_modes.hpp: adds a symmetric matrix over stabilising_unknowns()[component] (k x k).
  void add_stabilising(int component, const Eigen::MatrixXd& stabilising,
                       linalg::SymmetricMatrix& matrix) const;
  // Per component of rods, the free position unknowns of four vertices spread along its longest rod
  // and of two of every other, and the angle of an edge of the longest if it has angles.
  const std::vector<std::vector<int>>& stabilising_unknowns() const {
    return stabilising_unknowns_;
  }
  // Group of each rod, see model::components().
  const std::vector<int>& component_of_rod() const { return component_of_rod_; }

  // The state after a step of the free unknowns (size() entries).
  model::State displaced(const model::State& state, const Eigen::VectorXd& step) const;
  void displace(model::State& state, const Eigen::VectorXd& step) const;

 private:
  void lay_out();

  model::Structure structure_;
  geometry::Side side_;
  std::vector<geometry::ArcLength> arc_lengths_;
  std::vector<springs::Stencil> stencils_;
  std::vector<std::vector<int>> index_;
  std::vector<std::vector<int>> elements_;      // in free unknowns: of rods, cables, components
  std::size_t rod_elements_ = 0;                // how many of them are of rods
  std::vector<Eigen::Matrix3Xd> vertex_loads_;  // force on every vertex of every rod, or no rods
  Eigen::VectorXd load_gradient_;
  std::vector<int> component_of_rod_;
  std::vector<std::vector<int>> stabilising_unknowns_;
  std::unique_ptr<linalg::SymmetricAssembler> assembler_;
  int size_ = 0;
  int saddle_unknowns_ = 0;
};

// The forces after a step of the free unknowns, by linearisation at `state`.
InternalForces predicted_forces(const System& system, const model::State& state,
                                const Eigen::VectorXd& step);

}  // namespace tencer::equilibrium
