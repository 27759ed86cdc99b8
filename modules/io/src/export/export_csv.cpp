#include <tencer/core/names.hpp>
#include <tencer/model/vertex_fields.hpp>

#include "export/writers.hpp"
#include "text/text.hpp"

namespace tencer::io {

// A row a vertex, a blank line between rods, and a closed rod's first vertex again as its last: so
// that the table is a curve file, too.
std::string csv_table(const model::Design& design) {
  const std::string length = design.length_unit;
  std::string text = "rod,vertex,s (" + length + "),x (" + length + "),y (" + length + "),z (" +
                     length + "),deviation (" + length + "),curvature (1/" + length +
                     "),bending_strain,tension (" + design.force_unit + ")\n";
  const auto arcs = model::arc_lengths(design.structure);
  const auto fields = model::vertex_fields(design);
  for (std::size_t r = 0; r < fields.size(); ++r) {
    const model::VertexFields& field = fields[r];
    const Eigen::Matrix3Xd& pose = design.pose[r];
    if (r > 0) text += '\n';
    for (Eigen::Index row = 0; row < arcs[r].knots().size(); ++row) {
      const Eigen::Index i = row % pose.cols();
      text += csv_line(std::vector<std::string>{
          core::rod_name(static_cast<int>(r)), std::to_string(i), to_text(arcs[r].knots()[row]),
          to_text(pose(0, i)), to_text(pose(1, i)), to_text(pose(2, i)),
          to_text(field.deviation.col(i).norm()), to_text(field.curvature[i]),
          field.strain ? to_text((*field.strain)[i]) : "", to_text(field.tension[i])});
    }
  }
  return text;
}

}  // namespace tencer::io
