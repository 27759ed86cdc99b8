#include <tencer/der/curvature.hpp>
#include <tencer/der/energy.hpp>
#include <tencer/model/frames.hpp>
#include <tencer/model/vertex_fields.hpp>

namespace tencer::model {
namespace {

// The values of bending vertices, and 0 at the others.
Eigen::VectorXd at_all_vertices(const der::Rod& rod, const Eigen::VectorXd& bending) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(rod.vertices());
  for (int b = 0; b < rod.bending_vertices(); ++b) values[rod.bending_vertex(b)] = bending[b];
  return values;
}

// However its section is turned and whatever its shape at rest.
Eigen::VectorXd curvature_of(const der::Rod& rod, const Eigen::Matrix3Xd& pose) {
  const der::Rod plain{.closed = rod.closed, .section = {}, .rest_lengths = rod.rest_lengths};
  return at_all_vertices(
      rod, der::bending_curvature(plain, der::make_state(plain, pose)).colwise().norm());
}

std::optional<Eigen::VectorXd> strain_of(const der::Rod& rod, const Eigen::Matrix3Xd& pose,
                                         const Eigen::Matrix3Xd& directors) {
  if (!der::half_sizes(rod.section.shape)) return std::nullopt;
  der::RodState state = der::make_state(rod, pose);
  if (state.theta.size() > 0) {
    if (directors.cols() == 0) return std::nullopt;
    set_frames(state, directors);
  }
  const Eigen::Matrix2Xd bend = der::bending_curvature(rod, state);
  Eigen::VectorXd strain(bend.cols());
  for (Eigen::Index b = 0; b < bend.cols(); ++b)
    strain[b] = *der::bending_strain(rod.section.shape, bend(0, b), bend(1, b));
  return at_all_vertices(rod, strain);
}

Eigen::VectorXd tension_of(const der::Rod& rod, const Eigen::Matrix3Xd& pose) {
  const Eigen::VectorXd edges = der::axial_forces(rod, pose);
  Eigen::VectorXd tension = Eigen::VectorXd::Zero(rod.vertices());
  Eigen::VectorXd meeting = Eigen::VectorXd::Zero(rod.vertices());
  for (int e = 0; e < rod.edges(); ++e)
    for (const int vertex : {e, (e + 1) % rod.vertices()}) {
      tension[vertex] += edges[e];
      meeting[vertex] += 1;
    }
  return tension.cwiseQuotient(meeting);
}

}  // namespace

std::vector<VertexFields> vertex_fields(const Design& design) {
  std::vector<VertexFields> fields;
  for (std::size_t r = 0; r < design.structure.rods.size(); ++r) {
    const der::Rod& rod = design.structure.rods[r];
    const Eigen::Matrix3Xd& pose = design.pose[r];
    fields.push_back({.deviation = seeing(design.views) * (pose - design.target[r]),
                      .curvature = curvature_of(rod, pose),
                      .strain = strain_of(rod, pose, design.pose_directors[r]),
                      .tension = tension_of(rod, pose)});
  }
  return fields;
}

}  // namespace tencer::model
