// Rods, cables and structures with their energies and derivatives, where they rest, and how that
// changes with the cables.
#include <tencer/der/energy.hpp>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/stability.hpp>
#include <tencer/sensitivity/parameters.hpp>
#include <tencer/sensitivity/pose_map.hpp>

#include "arrays.hpp"
#include "long_call.hpp"
#include "parts.hpp"

namespace tencer::python {
namespace {

using namespace py::literals;
using Points = std::vector<Given>;
using OnRod = std::pair<int, double>;
using End = std::variant<OnRod, int>;
using ParameterName = std::pair<std::string, int>;

// The state of a structure's rods: vertices and material frames.
struct Pose {
  model::State state;
};

std::vector<Eigen::Matrix3Xd> matrices(const Points& arrays, const std::string& name) {
  std::vector<Eigen::Matrix3Xd> list;
  for (std::size_t r = 0; r < arrays.size(); ++r)
    list.emplace_back(points_of(arrays[r], name + "[" + std::to_string(r) + "]"));
  return list;
}

std::vector<py::array> positions(py::object self, const model::State& state) {
  std::vector<py::array> list;
  for (const der::RodState& rod : state) list.push_back(view(rod.x, self));
  return list;
}

der::Rod rod(const der::Section& section, const Given& rest_lengths, bool closed,
             std::optional<double> closing_angle) {
  der::Rod made{.closed = closed,
                .section = section,
                .rest_lengths = numbers_of(rest_lengths, "rest_lengths"),
                .closing_angle = closing_angle};
  der::validate(made);
  return made;
}

springs::End end_of(const End& end) {
  if (const auto* on_rod = std::get_if<OnRod>(&end))
    return springs::OnRod{on_rod->first, on_rod->second};
  return springs::AtAnchor{std::get<int>(end)};
}

End end_from(const springs::End& end) {
  if (const auto* on_rod = std::get_if<springs::OnRod>(&end)) return OnRod{on_rod->rod, on_rod->s};
  return std::get<springs::AtAnchor>(end).anchor;
}

model::Structure structure(std::vector<der::Rod> rods, std::vector<springs::Cable> cables,
                           const std::optional<Given>& anchors,
                           const std::vector<std::tuple<int, int, std::string>>& pins,
                           const std::vector<std::tuple<int, double, std::array<double, 3>>>& loads,
                           bool planar) {
  model::Structure made{.rods = std::move(rods), .cables = std::move(cables), .planar = planar};
  if (anchors) made.anchors = points_of(*anchors, "anchors");
  for (const auto& [of, vertex, axes] : pins) {
    model::Pin pin{.rod = of, .vertex = vertex};
    for (std::size_t axis = 0; axis < 3; ++axis)
      pin.axes[axis] = axes.find("xyz"[axis]) != std::string::npos;
    made.pins.push_back(pin);
  }
  for (const auto& [of, s, force] : loads)
    made.point_loads.push_back({of, s, {force[0], force[1], force[2]}});
  model::validate(made);
  return made;
}

std::vector<springs::Parameter> parameters_of(const std::vector<ParameterName>& names) {
  using enum springs::ParameterKind;
  std::vector<springs::Parameter> parameters;
  for (const auto& [kind, cable] : names) {
    const auto known = kind == "stiffness"     ? std::optional(stiffness)
                       : kind == "rest_length" ? std::optional(rest_length)
                       : kind == "s_a"         ? std::optional(position_a)
                       : kind == "s_b"         ? std::optional(position_b)
                                               : std::nullopt;
    if (!known)
      throw std::invalid_argument(
          "parameters: expected stiffness, rest_length, s_a or s_b, found " + kind);
    parameters.push_back({*known, cable});
  }
  return parameters;
}

// The lower triangle in compressed columns: (data, row of each, start of each column).
py::tuple hessian(const equilibrium::System& system, const Pose& pose) {
  linalg::SymmetricMatrix matrix = system.pattern();
  system.hessian(pose.state, system.internal_forces(pose.state), matrix);
  const auto filled = matrix.nonZeros();
  return py::make_tuple(py::array_t<double>(filled, matrix.valuePtr()),
                        py::array_t<int>(filled, matrix.innerIndexPtr()),
                        py::array_t<int>(matrix.cols() + 1, matrix.outerIndexPtr()));
}

// (n, 3) of each rod: the free unknown of each coordinate, -1 where it is held.
std::vector<py::array_t<int>> unknowns(const equilibrium::System& system) {
  std::vector<py::array_t<int>> list;
  const auto& rods = system.structure().rods;
  for (int r = 0; r < static_cast<int>(rods.size()); ++r) {
    py::array_t<int> indices({rods[r].vertices(), 3});
    auto at = indices.mutable_unchecked<2>();
    for (int vertex = 0; vertex < rods[r].vertices(); ++vertex)
      for (int axis = 0; axis < 3; ++axis)
        at(vertex, axis) = system.position_index(r, vertex, axis);
    list.push_back(indices);
  }
  return list;
}

// An equilibrium, of springs or, with tensions of their own, of inextensible cables.
struct Rest {
  equilibrium::Equilibrium found{};
  Eigen::VectorXd tensions{};
};

Rest solve(const model::Structure& of, const Pose& start, bool inextensible, double tolerance,
           int max_iterations) {
  return long_call(py::none(), [&](LongCall& call) -> Rest {
    const equilibrium::SolveOptions options{
        .tolerance = tolerance, .max_iterations = max_iterations, .stop = call.token()};
    if (inextensible) {
      auto relaxed = equilibrium::relax_inextensible(of, start.state, options);
      return {std::move(relaxed.equilibrium), std::move(relaxed.tensions)};
    }
    const equilibrium::System system(of);
    Rest rest{equilibrium::solve(system, start.state, options), {}};
    rest.tensions = system.internal_forces(rest.found.state).tension;
    return rest;
  });
}

equilibrium::Stability stability(const model::Structure& of, const Rest& rest, bool inextensible) {
  const py::gil_scoped_release free;
  if (!inextensible) return equilibrium::stability(equilibrium::System(of), rest.found.state);
  return equilibrium::assess(of, rest.found.state, rest.tensions).stability;
}

// The pose as a function of some parameters of the cables.
class PoseMap {
 public:
  PoseMap(const model::Structure& of, const Pose& start, const std::vector<ParameterName>& names)
      : parameters_(parameters_of(names)), tracker_(of, start.state) {
    values_ = sensitivity::values(of.cables, parameters_);
    if (!tracker_.first().usable())
      throw std::invalid_argument("start: no stable equilibrium is found from here: " +
                                  equilibrium::describe(tracker_.first().reason));
  }

  const Eigen::VectorXd& values() const { return values_; }
  const sensitivity::Configuration& at() const {
    return tried_ ? tracker_.trial() : tracker_.committed();
  }

  bool move(const Eigen::VectorXd& p) {
    trial_ =
        tracker_.evaluate(sensitivity::with_values(tracker_.committed().cables(), parameters_, p));
    tried_ = trial_.usable();
    if (tried_) values_ = p;
    return tried_;
  }
  std::string outcome() const { return sensitivity::describe(trial_.outcome); }

  void commit() {
    if (tried_) tracker_.commit();
    tried_ = false;
  }

  Eigen::VectorXd pull_back(const std::vector<Eigen::Matrix3Xd>& gradient) const {
    return sensitivity::pull_back(at(), parameters_, gradient);
  }
  std::vector<Eigen::Matrix3Xd> push_forward(const Eigen::VectorXd& change) const {
    return sensitivity::push_forward(at(), parameters_, change);
  }

 private:
  std::vector<springs::Parameter> parameters_;
  sensitivity::Tracker tracker_;
  sensitivity::Trial trial_{.outcome = sensitivity::Outcome::followed};
  Eigen::VectorXd values_;
  bool tried_ = false;
};

void bind_parts(py::module_& module) {
  py::class_<der::Section>(
      module, "Section",
      "EA in force, EI1, EI2 and GJ in force times length squared; EI1 resists "
      "curvature about the first axis.")
      .def(py::init([](double EA, double EI1, double EI2, double GJ) {
             return der::Section{.EA = EA, .EI1 = EI1, .EI2 = EI2, .GJ = GJ};
           }),
           "EA"_a, "EI1"_a, "EI2"_a, "GJ"_a)
      .def_static(
          "circle",
          [](double modulus, double radius, double poisson) {
            return der::solid_circle(modulus, poisson, radius);
          },
          "youngs_modulus"_a, "radius"_a, "poisson"_a = 0.3,
          "Young's modulus in force per length squared, radius a length.")
      .def_static(
          "rectangle",
          [](double modulus, double width, double height, double poisson) {
            return der::rectangle(modulus, poisson, width, height);
          },
          "youngs_modulus"_a, "width"_a, "height"_a, "poisson"_a = 0.3,
          "width along the first axis, height along the second.")
      .def_readonly("EA", &der::Section::EA)
      .def_readonly("EI1", &der::Section::EI1)
      .def_readonly("EI2", &der::Section::EI2)
      .def_readonly("GJ", &der::Section::GJ);

  py::class_<der::Rod>(module, "Rod", "A rod at rest: straight, or as set_rest_shape says.")
      .def(py::init(&rod), "section"_a, "rest_lengths"_a, "closed"_a = false,
           "closing_angle"_a = py::none(),
           "rest_lengths: of every edge, (edges,). closing_angle: of a closed rod that is twisted "
           "before its ends are glued, radians; None: free.")
      .def(
          "set_rest_shape",
          [](der::Rod& self, const Given& points, const Given& directors) {
            der::set_rest_shape(self, points_of(points, "points"),
                                points_of(directors, "directors"));
          },
          "points"_a, "directors"_a,
          "Makes the curve points (n, 3), with directors (edges, 3), its shape at rest.")
      .def_readonly("closed", &der::Rod::closed)
      .def_property_readonly(
          "rest_lengths",
          [](py::object self) { return view(self.cast<der::Rod&>().rest_lengths, self); })
      .def_property_readonly("vertices", &der::Rod::vertices)
      .def_property_readonly("length", &der::Rod::length);

  py::class_<springs::Cable>(
      module, "Cable",
      "A spring between two points: (rod, s) at an arc length, or the number "
      "of an anchor.")
      .def(py::init([](const End& a, const End& b, double stiffness, double rest_length,
                       bool tension_only) {
             return springs::Cable{.a = end_of(a),
                                   .b = end_of(b),
                                   .stiffness = stiffness,
                                   .rest_length = rest_length,
                                   .tension_only = tension_only};
           }),
           "a"_a, "b"_a, "stiffness"_a, "rest_length"_a, "tension_only"_a = false)
      .def_property_readonly("a", [](const springs::Cable& self) { return end_from(self.a); })
      .def_property_readonly("b", [](const springs::Cable& self) { return end_from(self.b); })
      .def_readonly("stiffness", &springs::Cable::stiffness, "Force per length.")
      .def_readonly("rest_length", &springs::Cable::rest_length)
      .def("__repr__",
           [](const springs::Cable& self) { return "<Cable " + springs::describe(self) + ">"; });

  py::class_<Pose>(module, "Pose", "Where the rods of a structure are, with their frames.")
      .def_property_readonly(
          "positions", [](py::object self) { return positions(self, self.cast<Pose&>().state); },
          "The vertices of each rod, (n, 3), read-only views.");
}

void bind_solvers(py::module_& module) {
  py::class_<model::Structure>(module, "Structure", "Rods, cables, supports and loads.")
      .def(py::init(&structure), "rods"_a, "cables"_a = py::list(), "anchors"_a = py::none(),
           "pins"_a = py::list(), "loads"_a = py::list(), "planar"_a = false,
           "anchors: (k, 3). pins: (rod, vertex, axes), such as (0, 0, \"xyz\"). loads: (rod, s, "
           "force), a force that keeps its direction.")
      .def_readonly("rods", &model::Structure::rods)
      .def_readonly("cables", &model::Structure::cables)
      .def(
          "pose",
          [](const model::Structure& self, const Points& points) {
            return Pose{model::make_state(self, matrices(points, "positions"))};
          },
          "positions"_a, "The rods with their vertices at positions, (n, 3) each, untwisted.")
      .def(
          "solve", &solve, "start"_a, "inextensible"_a = false, "tolerance"_a = 1e-10,
          "max_iterations"_a = 500,
          "Where it comes to rest from a Pose, such as that of another equilibrium (a warm start): "
          "with cables as springs, or as long as their rest lengths and inextensible.")
      .def("stability", &stability, "equilibrium"_a, "inextensible"_a = false,
           "The smallest eigenvalue of the Hessian apart from rigid motion.");

  py::class_<equilibrium::System>(module, "System", "Energy and derivatives in the free unknowns.")
      .def(py::init([](const model::Structure& of) { return equilibrium::System(of); }),
           "structure"_a)
      .def("__len__", &equilibrium::System::size)
      .def_property_readonly("unknowns", &unknowns,
                             "Per rod, (n, 3): which unknown a coordinate is, -1 where it is held.")
      .def(
          "energy",
          [](const equilibrium::System& self, const Pose& at) { return self.energy(at.state); },
          "pose"_a, "Force times length.")
      .def(
          "gradient",
          [](const equilibrium::System& self, const Pose& at) {
            return owned(self.gradient(at.state));
          },
          "pose"_a, "(unknowns,).")
      .def("lower_hessian", &hessian, "pose"_a,
           "The lower triangle in compressed columns: (data, indices, indptr).")
      .def(
          "displaced",
          [](const equilibrium::System& self, const Pose& at, const Given& step) {
            const auto numbers = numbers_of(step, "step");
            core::require(numbers.size() == self.size(), "step: needs a number for every unknown");
            return Pose{self.displaced(at.state, numbers)};
          },
          "pose"_a, "step"_a, "The pose after a step (unknowns,); frames are carried along.");

  py::class_<Rest>(module, "Equilibrium", "Where a structure came to rest, or why it did not.")
      .def_property_readonly("usable", [](const Rest& self) { return self.found.usable(); })
      .def_property_readonly(
          "reason", [](const Rest& self) { return equilibrium::describe(self.found.reason); })
      .def_property_readonly("pose", [](const Rest& self) { return Pose{self.found.state}; })
      .def_property_readonly(
          "positions",
          [](py::object self) { return positions(self, self.cast<Rest&>().found.state); },
          "The vertices of each rod, (n, 3), read-only views.")
      .def_property_readonly(
          "tensions", [](py::object self) { return view(self.cast<Rest&>().tensions, self); },
          "Of each cable, (cables,), forces.")
      .def_property_readonly("residual", [](const Rest& self) { return self.found.residual; })
      .def_property_readonly("energy", [](const Rest& self) { return self.found.energy; })
      .def_property_readonly("iterations", [](const Rest& self) { return self.found.iterations; });

  py::class_<equilibrium::Stability>(module, "Stability", "Whether a pose is stable, and how firm.")
      .def_readonly("smallest_eigenvalue", &equilibrium::Stability::smallest_eigenvalue,
                    "In max EI / L^4, one unit of mass per length.")
      .def_readonly("negative", &equilibrium::Stability::negative)
      .def_property_readonly("stable", &equilibrium::Stability::stable);
}

}  // namespace

void bind_structure(py::module_& module) {
  bind_parts(module);
  bind_solvers(module);
  py::class_<PoseMap>(
      module, "PoseMap",
      "The pose as a function of parameters of the cables, followed along one branch "
      "of equilibria, with its derivative both ways.")
      .def(py::init<const model::Structure&, const Pose&, const std::vector<ParameterName>&>(),
           "structure"_a, "start"_a, "parameters"_a,
           "parameters: (kind, cable), kind one of rest_length, stiffness, s_a and s_b. Raises "
           "ValueError when the structure does not come to rest from `start`.")
      .def_property_readonly(
          "values", [](const PoseMap& self) { return owned(self.values()); },
          "The parameters' values now, (parameters,).")
      .def(
          "move",
          [](PoseMap& self, const Given& p) {
            const Eigen::VectorXd numbers = numbers_of(p, "values");
            const py::gil_scoped_release free;
            return self.move(numbers);
          },
          "values"_a,
          "Solves for the pose with these values, on the branch of the committed pose. False where "
          "it is lost; everything then is as it was committed.")
      .def_property_readonly("outcome", &PoseMap::outcome, "How the last move went, in words.")
      .def("commit", &PoseMap::commit, "Further moves start from this pose.")
      .def_property_readonly(
          "positions",
          [](const PoseMap& self) {
            std::vector<py::array> list;
            for (const der::RodState& rod : self.at().state) list.push_back(owned(rod.x));
            return list;
          },
          "The vertices of each rod, (n, 3).")
      .def(
          "pull_back",
          [](const PoseMap& self, const Points& gradient) {
            return owned(self.pull_back(matrices(gradient, "gradient")));
          },
          "gradient"_a,
          "dF/dp, (parameters,), of any function F of the positions from dF/dx, (n, 3) of each "
          "rod.")
      .def(
          "push_forward",
          [](const PoseMap& self, const Given& change) {
            std::vector<py::array> list;
            for (const Eigen::Matrix3Xd& motion : self.push_forward(numbers_of(change, "change")))
              list.push_back(owned(motion));
            return list;
          },
          "change"_a, "How positions change, (n, 3) of each rod, with a change (parameters,).");
}

}  // namespace tencer::python
