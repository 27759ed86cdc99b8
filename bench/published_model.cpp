#include "published_model.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>
#include <tencer/der/section.hpp>

namespace bench {
namespace {

using nlohmann::json;
namespace springs = tencer::springs;

Eigen::Matrix3Xd points(const json& list) {
  Eigen::Matrix3Xd result(3, static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      result(axis, static_cast<Eigen::Index>(i)) = list[i][axis].get<double>();
  return result;
}

springs::End end_of(const json& end) {
  if (end.contains("anchor")) return springs::AtAnchor{end["anchor"].get<int>()};
  return springs::OnRod{end["rod"].get<int>(), end["s"].get<double>()};
}

// The models were computed with the section of an inscribed 1000-sided polygon instead of a circle:
// EA smaller by 6.6e-6, EI and GJ by 1.3e-5. Stored equilibria are those of these constants.
tencer::der::Section polygonal(tencer::der::Section circle) {
  const double angle = 2 * std::numbers::pi / 1000;
  const double area = std::sin(angle) / angle;
  const double inertia = area * (2 + std::cos(angle)) / 3;
  return {.EA = circle.EA * area,
          .EI1 = circle.EI1 * inertia,
          .EI2 = circle.EI2 * inertia,
          .GJ = circle.GJ * inertia};
}

}  // namespace

PublishedModel read_published_model(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  const json content = json::parse(file);
  PublishedModel model;
  model.name = content["name"];
  for (const auto& entry : content["rods"]) {
    const auto lengths = entry["rest_lengths"].get<std::vector<double>>();
    tencer::der::Rod rod;
    rod.closed = entry["closed"];
    rod.section =
        polygonal(tencer::der::solid_circle(entry["youngs_modulus"], 0.5, entry["radius"]));
    rod.rest_lengths = Eigen::Map<const Eigen::VectorXd>(lengths.data(),
                                                         static_cast<Eigen::Index>(lengths.size()));
    model.structure.rods.push_back(rod);
    model.target.push_back(points(entry["target"]));
    model.published.push_back(points(entry["published_equilibrium"]));
  }
  model.structure.anchors = points(content["anchors"]);
  for (const auto& cable : content["cables"])
    model.structure.cables.push_back({.a = end_of(cable["a"]),
                                      .b = end_of(cable["b"]),
                                      .stiffness = cable["stiffness"],
                                      .rest_length = cable["rest_length"]});
  const auto flat = [](const Eigen::Matrix3Xd& x) { return (x.row(2).array() == x(2, 0)).all(); };
  model.structure.planar = std::ranges::all_of(model.target, flat);
  model.cables = content["published"]["cables"];
  model.max_error_percent = content["published"]["max_error_percent"];
  model.rigidly_aligned = content["published"]["rigidly_aligned"];
  return model;
}

std::vector<PublishedModel> read_published_models(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json") paths.push_back(entry.path());
  std::ranges::sort(paths);
  std::vector<PublishedModel> models;
  for (const auto& path : paths) models.push_back(read_published_model(path));
  return models;
}

}  // namespace bench
