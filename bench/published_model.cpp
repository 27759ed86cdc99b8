#include "published_model.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <tencer/io/design.hpp>

namespace bench {
namespace {

PublishedModel read_published_model(const std::filesystem::path& path) {
  auto design = tencer::io::read_design(path);
  if (!design) throw std::runtime_error(design.error().text());
  std::ifstream file(path);
  return {.design = std::move(*design),
          .max_error_percent = nlohmann::json::parse(file).at("published").at("max_error_percent")};
}

}  // namespace

std::vector<PublishedModel> read_published_models(const std::string& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json") paths.push_back(entry.path());
  std::ranges::sort(paths);
  std::vector<PublishedModel> models;
  for (const auto& path : paths) models.push_back(read_published_model(path));
  return models;
}

}  // namespace bench
