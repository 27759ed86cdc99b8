#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <tencer/pipeline/symmetry.hpp>
#include <tuple>
#include <utility>
#include <vector>

namespace tencer::pipeline {
namespace {

using symmetry::Operation;

constexpr double same = 1e-9;  // relative difference of stiffnesses and weights
constexpr double near = 2e-3;  // of places along a rod, relative to its length: twice the misfit

bool equal(double a, double b) {
  return std::abs(a - b) <= same * std::max(std::abs(a), std::abs(b));
}

bool same_rod(const der::Rod& a, const der::Rod& b) {
  return equal(a.section.EA, b.section.EA) && equal(a.section.EI1, b.section.EI1) &&
         equal(a.section.EI2, b.section.EI2) && equal(a.section.GJ, b.section.GJ) &&
         a.closing_angle.has_value() == b.closing_angle.has_value() &&
         equal(a.closing_angle.value_or(0), b.closing_angle.value_or(0));
}

symmetry::Figure figure_of(const Prepared& prepared) {
  const auto& structure = prepared.structure;
  symmetry::Figure figure{.anchors = structure.anchors};
  for (std::size_t r = 0; r < structure.rods.size(); ++r) {
    const auto& rod = structure.rods[r];
    figure.curves.push_back({.points = prepared.target.points[r], .closed = rod.closed});
    figure.rods.emplace_back(rod.rest_lengths, rod.closed);
    const auto alike = std::ranges::find_if(
        structure.rods, [&](const der::Rod& other) { return same_rod(other, rod); });
    figure.classes.push_back(static_cast<int>(alike - structure.rods.begin()));
  }
  return figure;
}

// What an operation would break that is not to be seen of curves and anchors.
class Objections {
 public:
  Objections(const Prepared& prepared, const symmetry::Figure& figure)
      : structure_(prepared.structure),
        target_(prepared.target),
        rules_(prepared.rules),
        rods_(figure.rods) {}

  std::string operator()(const Operation& operation) const {
    for (const auto test : {&Objections::frames, &Objections::pins, &Objections::loads,
                            &Objections::weights, &Objections::rules})
      if (std::string text = (this->*test)(operation); !text.empty()) return text;
    return {};
  }

 private:
  static std::string rod_name(std::size_t rod) { return "rod " + std::to_string(rod); }

  bool close(int rod, double a, double b) const {
    const auto& along = rods_[rod];
    const double apart = along.closed() ? std::remainder(a - b, along.length()) : a - b;
    return std::abs(apart) <= near * along.length();
  }

  springs::OnRod image(const Operation& operation, int rod, double s) const {
    return std::get<springs::OnRod>(symmetry::image(operation, springs::OnRod{rod, s}, rods_));
  }

  std::string frames(const Operation& operation) const {
    for (std::size_t r = 0; r < structure_.rods.size(); ++r) {
      const der::Rod& rod = structure_.rods[r];
      switch (der::twist_model(rod)) {
        case der::TwistModel::per_edge:
          return "does not know the sides of " + rod_name(r) +
                 ", which is not round or not straight at rest";
        case der::TwistModel::uniform:
          if (operation.matrix.determinant() < 0 && rod.closing_angle != 0.0)
            return "would twist " + rod_name(r) + " the other way";
          break;
        case der::TwistModel::none:
          break;
      }
    }
    return {};
  }

  // The directions in which pins hold each vertex, as a projection.
  std::string pins(const Operation& operation) const {
    std::map<std::pair<int, int>, Eigen::Matrix3d> held;
    for (const auto& pin : structure_.pins) {
      auto& axes = held.try_emplace({pin.rod, pin.vertex}, Eigen::Matrix3d::Zero()).first->second;
      for (int axis = 0; axis < 3; ++axis)
        if (pin.axes[axis]) axes(axis, axis) = 1;
    }
    for (const auto& [at, axes] : held) {
      const auto place = image(operation, at.first, rods_[at.first].knots()[at.second]);
      const Eigen::Matrix3d turned = operation.matrix * axes * operation.matrix.transpose();
      const bool kept = std::ranges::any_of(held, [&](const auto& other) {
        const auto [rod, vertex] = other.first;
        return rod == place.rod && close(rod, rods_[rod].knots()[vertex], place.s) &&
               (other.second - turned).norm() < near;
      });
      if (!kept)
        return "does not keep the pins: vertex " + std::to_string(at.second) + " of " +
               rod_name(at.first) + " is pinned, but not what it becomes";
    }
    return {};
  }

  std::string loads(const Operation& operation) const {
    const auto turned = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
      return (operation.matrix * from - to).norm() <= near * from.norm();
    };
    for (std::size_t i = 0; i < structure_.point_loads.size(); ++i) {
      const auto& load = structure_.point_loads[i];
      const auto place = image(operation, load.rod, load.s);
      if (std::ranges::none_of(structure_.point_loads, [&](const auto& other) {
            return other.rod == place.rod && close(other.rod, other.s, place.s) &&
                   turned(load.force, other.force);
          }))
        return "does not keep load " + std::to_string(i);
    }
    for (const auto& load : structure_.line_loads) {
      const int rod = operation.rods[load.rod].rod;
      if (std::ranges::none_of(structure_.line_loads, [&](const auto& other) {
            return other.rod == rod && turned(load.force_per_length, other.force_per_length);
          }))
        return "does not keep gravity";
    }
    return {};
  }

  std::string weights(const Operation& operation) const {
    for (std::size_t r = 0; r < target_.weights.size(); ++r)
      for (Eigen::Index i = 0; i < target_.weights[r].size(); ++i) {
        const int from = static_cast<int>(r);
        const auto place = image(operation, from, rods_[r].knots()[i]);
        const auto edge = rods_[place.rod].locate(place.s).edge;
        const auto& there = target_.weights[place.rod];
        // One of the vertices next to the image.
        const Eigen::Index n = there.size();
        bool kept = false;
        for (const Eigen::Index k : {edge + n - 1, edge + n, edge + n + 1, edge + n + 2})
          kept = kept || equal(there[k % n], target_.weights[r][i]);
        if (!kept) return "does not keep the weights of " + rod_name(r);
      }
    return {};
  }

  std::string rules(const Operation& operation) const {
    for (const auto& arc : rules_.forbidden) {
      auto from = image(operation, arc.rod, arc.from);
      auto to = image(operation, arc.rod, arc.to);
      if (operation.rods[arc.rod].rate < 0) std::swap(from, to);
      if (std::ranges::none_of(rules_.forbidden, [&](const auto& other) {
            return other.rod == from.rod && close(other.rod, other.from, from.s) &&
                   close(other.rod, other.to, to.s);
          }))
        return "brings a forbidden arc of " + rod_name(arc.rod) + " to where cables are allowed";
    }
    for (std::size_t a = 0; a < rods_.size(); ++a)
      for (std::size_t b = a; b < rods_.size(); ++b)
        if (sparsify::pair_allowed(rules_, static_cast<int>(a), static_cast<int>(b)) !=
            sparsify::pair_allowed(rules_, operation.rods[a].rod, operation.rods[b].rod))
          return "does not keep the pairs of rods that cables may join";
    return {};
  }

  const equilibrium::Structure& structure_;
  const sensitivity::Target& target_;
  const sparsify::Rules& rules_;
  const std::vector<geometry::ArcLength>& rods_;
};

// Of the rods' length, which every symmetry keeps.
Eigen::Vector3d centroid(const symmetry::Figure& figure) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double length = 0;
  for (const auto& curve : figure.curves) {
    const Eigen::VectorXd edges = geometry::edge_lengths(curve);
    for (Eigen::Index i = 0; i < edges.size(); ++i)
      sum += edges[i] / 2 * (curve.points.col(i) + curve.points.col((i + 1) % curve.points.cols()));
    length += edges.sum();
  }
  const Eigen::Vector3d middle = sum / length;
  // What is zero but for rounding is told as zero.
  return (middle.array().abs() > 1e-12 * length).select(middle, 0);
}

std::vector<symmetry::Generator> generators_of(const io::Scene& scene,
                                               const symmetry::Figure& figure, const Units& units) {
  const Eigen::Vector3d middle = centroid(figure);
  const auto point = [&](const std::optional<Eigen::Vector3d>& given) -> Eigen::Vector3d {
    if (!given) return middle;
    return units.scaled(*given);
  };
  std::vector<symmetry::Generator> result;
  for (const auto& generator : scene.design.generators) {
    if (const auto* rotation = std::get_if<io::Rotation>(&generator))
      result.push_back(symmetry::Rotation{
          .point = point(rotation->point), .axis = rotation->axis, .fold = rotation->fold});
    else {
      const auto& reflection = std::get<io::Reflection>(generator);
      result.push_back(
          symmetry::Reflection{.point = point(reflection.point), .normal = reflection.normal});
    }
  }
  return result;
}

core::Expected<symmetry::Symmetry> given(const io::Scene& scene, const Prepared& prepared) {
  const symmetry::Figure figure = figure_of(prepared);
  const auto generators = generators_of(scene, figure, prepared.units);
  const symmetry::Options options{.objection = Objections(prepared, figure)};
  auto found = symmetry::verify(figure, generators, options);
  if (found) return found;
  // Again in the scene's coordinates, for the message.
  symmetry::Figure unscaled = figure;
  const double length = prepared.units.scale.length;
  unscaled.rods.clear();
  for (auto& curve : unscaled.curves) curve.points = prepared.units.unscaled(curve.points);
  for (const auto& rod : prepared.structure.rods)
    unscaled.rods.emplace_back(length * rod.rest_lengths, rod.closed);
  unscaled.anchors = prepared.units.unscaled(unscaled.anchors);
  const auto again = symmetry::verify(unscaled, generators_of(scene, unscaled, Units{}),
                                      {.objection = [&](const Operation& operation) {
                                        Operation scaled = operation;
                                        for (auto& map : scaled.rods) map.offset /= length;
                                        return options.objection(scaled);
                                      }});
  const core::Error& error = again ? found.error() : again.error();
  return core::Error{scene.source, "design." + error.where + ": " + error.message};
}

const double exact = symmetry::Options{}.tolerance;

symmetry::Symmetry detected(const Prepared& prepared, double tolerance) {
  const symmetry::Figure figure = figure_of(prepared);
  return symmetry::detect(figure,
                          {.tolerance = tolerance, .objection = Objections(prepared, figure)});
}

std::string direction_text(const Eigen::Vector3d& direction) {
  std::ostringstream text;
  text.precision(3);
  const auto rounded = [&](double x) { return std::abs(x) < 5e-4 ? 0.0 : x; };
  text << '(' << rounded(direction.x()) << ", " << rounded(direction.y()) << ", "
       << rounded(direction.z()) << ')';
  return text.str();
}

}  // namespace

core::Expected<std::optional<symmetry::Group>> symmetry_of(const io::Scene& scene,
                                                           const Prepared& prepared) {
  std::optional<symmetry::Group> group;
  if (scene.design.symmetry == "given") {
    auto found = given(scene, prepared);
    if (!found) return found.error();
    group = std::move(found->group);
  } else if (scene.design.symmetry == "detect") {
    group = detected(prepared, exact).group;
  }
  if (group && group->order() == 1) group.reset();
  return group;
}

symmetry::Group near_symmetry(const Prepared& prepared) {
  constexpr double nearly = 1e-2;
  return detected(prepared, nearly).group;
}

std::string symmetry_in_words(const Prepared& prepared) {
  const symmetry::Symmetry found = detected(prepared, exact);
  if (found.group.order() == 1) return {};
  std::vector<std::string> parts;
  int axes = 0;
  int planes = 0;
  std::string first_plane;
  for (const auto& element : found.elements) {
    if (const auto* rotation = std::get_if<symmetry::Rotation>(&element)) {
      // The highest fold comes first.
      if (++axes == 1)
        parts.push_back("a " + std::to_string(rotation->fold) + "-fold rotation about " +
                        direction_text(rotation->axis));
    } else if (++planes == 1) {
      first_plane = direction_text(std::get<symmetry::Reflection>(element).normal);
    }
  }
  if (axes > 1) parts.push_back(std::to_string(axes - 1) + " further axes of rotation");
  if (planes == 1) parts.push_back("a mirror plane across " + first_plane);
  if (planes > 1) parts.push_back(std::to_string(planes) + " mirror planes");
  if (parts.empty())
    return std::to_string(found.group.order()) + " operations that map it onto itself";
  std::string text = parts[0];
  for (std::size_t i = 1; i < parts.size(); ++i)
    text += (i + 1 < parts.size() ? ", " : " and ") + parts[i];
  return text;
}

}  // namespace tencer::pipeline
