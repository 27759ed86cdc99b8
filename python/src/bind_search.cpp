// The search for cables stage by stage: what cables there may be, which of them balance the forces,
// and fewer of them.
#include <tencer/elimination/eliminate.hpp>
#include <tencer/elimination/search.hpp>
#include <tencer/ground_structure/balanced_tensions.hpp>
#include <tencer/ground_structure/force_balance.hpp>
#include <tencer/network/network.hpp>
#include <tencer/pipeline/prepare.hpp>
#include <tencer/sensitivity/distance.hpp>

#include "cable_rows.hpp"
#include "errors.hpp"
#include "long_call.hpp"
#include "parts.hpp"

namespace tencer::python {
namespace {

using namespace py::literals;
using pipeline::Prepared;

// A network of scaled units, with what brings it back to the scene's.
struct Network {
  network::Network network{};
  model::Scaling scaling{};
  network::Fault fault = network::Fault::not_checked;
  double max_percent = 0.0;
};

Network with_distance(network::Network network, network::Fault fault, const Prepared& of) {
  const double percent = sensitivity::deviation(of.problem.target, network.state).max_percent;
  return {std::move(network), of.scaling, fault, percent};
}

py::array_t<CableRow> cable_table(const Network& self) {
  const model::Structure& structure = self.network.structure;
  const Eigen::VectorXd lengths = cable_lengths(self.network) * self.scaling.scale.length;
  const Eigen::VectorXd tensions = cable_tensions(self.network) * self.scaling.scale.force();
  std::vector<CableRow> rows;
  for (std::size_t i = 0; i < structure.cables.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    rows.push_back(row_of(model::unscaled(structure.cables[i], structure, self.scaling),
                          lengths[at], tensions[at]));
  }
  return table(rows);
}

std::vector<py::array> positions(const Network& self) {
  std::vector<py::array> list;
  for (const der::RodState& rod : self.network.state)
    list.push_back(owned(self.scaling.unscaled(rod.x)));
  return list;
}

// With the lengths that they have at the target.
py::array_t<CableRow> candidates(const Prepared& self) {
  const ground_structure::Problem& problem = self.problem;
  network::Network all = problem.bare();
  all.structure.cables = problem.candidates;
  const Eigen::VectorXd lengths = cable_lengths(all) * self.scaling.scale.length;
  std::vector<CableRow> rows;
  for (std::size_t i = 0; i < problem.candidates.size(); ++i)
    rows.push_back(row_of(model::unscaled(problem.candidates[i], problem.structure, self.scaling),
                          lengths[static_cast<Eigen::Index>(i)], 0));
  return table(rows);
}

py::array balanced_tensions(const Prepared& self, double max_error) {
  const ground_structure::Problem& problem = self.problem;
  Eigen::VectorXd tensions =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(problem.candidates.size()));
  {
    const py::gil_scoped_release free;
    const equilibrium::System bare(problem.structure);
    std::vector<ground_structure::CandidateOrbit> single =
        ground_structure::candidate_orbits(bare, problem.start, problem.candidates, nullptr);
    const double accuracy = max_error / 100 * model::diagonal(problem.target);
    const auto found = ground_structure::balanced_tensions(bare, problem.start, single, accuracy);
    if (!found) throw std::invalid_argument("the rods' energy at the target is not finite");
    for (std::size_t i = 0; i < found->set.size(); ++i)
      tensions[found->set[i]] =
          found->values[static_cast<Eigen::Index>(i)] * self.scaling.scale.force();
  }
  return owned(tensions);
}

Network balance(const Prepared& self, double max_error) {
  return long_call(py::none(), [&](LongCall& call) {
    auto stage = force_balance(self.problem, self.problem.group(), {.max_error_percent = max_error},
                               {.stop = call.token()});
    return with_distance(std::move(stage.network), stage.fault, self);
  });
}

std::vector<Network> networks(const elimination::EliminationResult& found, const Prepared& of) {
  std::vector<Network> list;
  for (const elimination::Solution& solution : found.solutions)
    list.push_back({solution.network, of.scaling, network::Fault::none, solution.max_percent});
  return list;
}

elimination::EliminationOptions options(double max_error, int cables) {
  return {.goal = {.max_error_percent = max_error, .cables = cables}};
}

std::vector<Network> eliminate(const Prepared& self, const Network& network, double max_error,
                               int cables, py::object progress) {
  return long_call(std::move(progress), [&](LongCall& call) {
    return networks(
        elimination::eliminate(network.network, self.problem, options(max_error, cables),
                               {.stop = call.token(), .progress = call.sink()}),
        self);
  });
}

std::vector<Network> search(const Prepared& self, double max_error, int cables,
                            py::object progress) {
  return long_call(std::move(progress), [&](LongCall& call) {
    return networks(elimination::search(self.problem, options(max_error, cables),
                                        {.stop = call.token(), .progress = call.sink()}),
                    self);
  });
}

}  // namespace

void bind_search(py::module_& module) {
  py::class_<Network>(module, "Network",
                      "Cables with the pose in which rods rest under them, in the scene's units.")
      .def_property_readonly("cables", &cable_table, cable_columns)
      .def_property_readonly("positions", &positions, "The vertices of each rod, (n, 3).")
      .def_readonly("max_percent", &Network::max_percent,
                    "Largest distance from the target, % of its bounding-box diagonal.")
      .def_property_readonly(
          "valid", [](const Network& self) { return self.fault == network::Fault::none; },
          "Whether it is in stable equilibrium with every cable pulling.")
      .def_property_readonly(
          "fault", [](const Network& self) { return network::describe(self.fault); },
          "Why not, in words.")
      .def("__len__", [](const Network& self) { return cable_count(self.network); });

  py::class_<Prepared>(module, "Problem",
                       "A scene as the search takes it: tencer.prepare makes it. Its stages may be "
                       "run one by one.")
      .def_property_readonly(
          "candidates", &candidates,
          "The cables that the rules allow, a row each, with their lengths at the "
          "target.")
      .def("balanced_tensions", &balanced_tensions, "max_error"_a = 0.1,
           "Tensions >= 0 of the candidates, (candidates,), forces, most of them 0, at which the "
           "forces left over move no vertex by more than max_error, % of the target's diagonal.")
      .def("balance", &balance, "max_error"_a = 0.1,
           "A Network of candidates that balance the forces at the target.")
      .def("eliminate", &eliminate, "network"_a, "max_error"_a = 1.0, "cables"_a = 0,
           "progress"_a = py::none(),
           "Networks of ever fewer cables, the fewest first, out of one that holds the target: "
           "until "
           "max_error, %, is passed, or, with `cables`, down to so many.")
      .def("search", &search, "max_error"_a = 1.0, "cables"_a = 0, "progress"_a = py::none(),
           "The same without a network to start from.");
  module.def(
      "prepare",
      [](const model::Scene& scene) {
        const py::gil_scoped_release free;
        return value_or_raise(pipeline::prepare(scene));
      },
      "scene"_a);
}

}  // namespace tencer::python
