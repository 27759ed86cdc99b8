
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <tencer/core/names.hpp>
#include <tencer/ground_structure/problem_symmetry.hpp>
#include <tuple>
#include <utility>
#include <vector>

namespace tencer::ground_structure {
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

// What an operation would break that is not to be seen of curves and anchors.
class Constraints {
 public:
  Constraints(const Problem& problem, const symmetry::Figure& figure)
      : structure_(problem.structure),
        target_(problem.target),
        rules_(problem.rules),
        rods_(figure.rods) {}

  std::string operator()(const Operation& operation) const {
    for (const auto test : {&Constraints::frames, &Constraints::pins, &Constraints::loads,
                            &Constraints::weights, &Constraints::views, &Constraints::rules})
      if (std::string text = (this->*test)(operation); !text.empty()) return text;
    return {};
  }

 private:
  std::string named(std::size_t rod) const { return core::rod_in_words(rod, rods_.size()); }

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
          return "does not know the sides of " + named(r) +
                 ", which is not round or not straight at rest";
        case der::TwistModel::uniform:
          if (operation.matrix.determinant() < 0 && rod.closing_angle != 0.0)
            return "would twist " + named(r) + " the other way";
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
               named(at.first) + " is pinned, but not what it becomes";
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
        return "does not keep loads[" + std::to_string(i) + "]";
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

  std::string views(const Operation& operation) const {
    const Eigen::Matrix3d metric = model::seen_metric(target_.views);
    const Eigen::Matrix3d turned = operation.matrix * metric * operation.matrix.transpose();
    return (turned - metric).norm() < near ? "" : "does not keep what is seen of the rods";
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
        if (!kept) return "does not keep the weights of " + named(r);
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
        return "brings a forbidden arc of " + named(arc.rod) + " to where cables are allowed";
    }
    for (std::size_t a = 0; a < rods_.size(); ++a)
      for (std::size_t b = a; b < rods_.size(); ++b)
        if (model::pair_allowed(rules_, static_cast<int>(a), static_cast<int>(b)) !=
            model::pair_allowed(rules_, operation.rods[a].rod, operation.rods[b].rod))
          return "does not keep the pairs of rods that cables may join";
    return {};
  }

  const model::Structure& structure_;
  const model::Target& target_;
  const model::Rules& rules_;
  const std::vector<geometry::ArcLength>& rods_;
};

}  // namespace

symmetry::Figure figure_of(const Problem& problem) {
  const auto& structure = problem.structure;
  symmetry::Figure figure{.rods = model::arc_lengths(structure), .anchors = structure.anchors};
  for (std::size_t r = 0; r < structure.rods.size(); ++r) {
    const auto& rod = structure.rods[r];
    figure.curves.push_back({.points = problem.target.points[r], .closed = rod.closed});
    const auto alike = std::ranges::find_if(
        structure.rods, [&](const der::Rod& other) { return same_rod(other, rod); });
    figure.classes.push_back(static_cast<int>(alike - structure.rods.begin()));
  }
  return figure;
}

std::string broken_by(const Operation& operation, const Problem& problem,
                      const symmetry::Figure& figure) {
  return Constraints(problem, figure)(operation);
}

symmetry::Symmetry detected(const Problem& problem, double tolerance) {
  const symmetry::Figure figure = figure_of(problem);
  return symmetry::detect(figure,
                          {.tolerance = tolerance, .objection = [&](const Operation& operation) {
                             return broken_by(operation, problem, figure);
                           }});
}

}  // namespace tencer::ground_structure
