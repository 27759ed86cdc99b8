#include "scene/scene_views.hpp"

namespace tencer::io {

std::vector<model::View> read_views(const TomlTable& design, bool planar) {
  if (planar)
    design.fail("view",
                "a planar scene is seen along z as it is; leave out view, or planar where the rods "
                "may leave the plane");
  std::vector<model::View> views;
  if (design.is_array_of_tables("view")) {
    for (const TomlTable& table : design.tables("view")) {
      table.only({"direction", "weight"});
      views.push_back({.direction = table.need("direction", table.point("direction")),
                       .weight = table.positive("weight").value_or(1.0)});
      if (!(views.back().direction.norm() > 0))
        table.fail("direction", "must not be zero: nothing is seen along it");
    }
  } else if (design.is_array_of_arrays("view")) {
    const Eigen::Matrix3Xd directions = *design.points("view");
    for (const auto& direction : directions.colwise()) views.push_back({.direction = direction});
  } else {
    views.push_back({.direction = *design.point("view")});
  }
  if (const auto problem = model::view_problem(views)) design.fail("view", *problem);
  return views;
}

}  // namespace tencer::io
