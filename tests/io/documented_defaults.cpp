// docs/scene.md says the defaults that the code has.
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <tencer/model/scene.hpp>

using namespace tencer;

namespace {

// The second column of the page's tables by the first, both without backquotes.
std::map<std::string, std::string> documented() {
  std::ifstream page(TENCER_DOCS "/scene.md");
  std::map<std::string, std::string> defaults;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("| `")) continue;
    std::istringstream cells(line.substr(1));
    std::string key;
    std::string value;
    std::getline(cells, key, '|');
    std::getline(cells, value, '|');
    const auto bare = [](std::string text) {
      std::erase(text, '`');
      const auto first = text.find_first_not_of(' ');
      return first == std::string::npos
                 ? ""
                 : text.substr(first, text.find_last_not_of(' ') - first + 1);
    };
    defaults[bare(key)] = bare(value);
  }
  return defaults;
}

std::string in_quotes(std::string_view text) { return '"' + std::string(text) + '"'; }

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

}  // namespace

TEST_CASE("the page of the scene file has the defaults of the code") {
  const auto page = documented();
  REQUIRE(page.size() > 20);
  const model::Scene scene;
  const model::DesignSettings& settings = scene.design;
  CHECK(page.at("length_unit") == in_quotes(scene.length_unit));
  CHECK(page.at("force_unit") == in_quotes(scene.force_unit));
  CHECK(page.at("planar") == (scene.structure.planar ? "true" : "false"));
  CHECK(page.at("method") == in_quotes(model::name_of(settings.method)));
  CHECK(page.at("optimizer") == in_quotes(model::name_of(settings.optimizer)));
  CHECK(page.at("hessian") == in_quotes(model::name_of(settings.hessian)));
  CHECK(page.at("objective") == in_quotes(model::name_of(settings.objective)));
  CHECK(page.at("symmetry") == in_quotes(model::name_of(settings.symmetry)));
  CHECK(page.at("max_error") == number(settings.max_error));
  CHECK(page.at("effort") == number(settings.effort));
  CHECK(page.at("cables") == (settings.cables ? number(*settings.cables) : "none"));
  CHECK(page.at("external") == (scene.rules.external ? "true" : "false"));
  CHECK(page.at("hand_over") == (settings.hand_over ? "true" : "false"));
  CHECK(page.at("spring_stiffness") == number(settings.spring_stiffness));
  CHECK(page.at("greedy_threshold") == "5e-6");
  CHECK(settings.greedy_threshold == 5e-6);
  CHECK(page.at("sparsity_weights") == "0, 1, 10, ... 1e8");
  CHECK(settings.sparsity_weights.size() == 10);
  CHECK(settings.sparsity_weights.back() == 1e8);
}

TEST_CASE("the page of the scene file has the materials of the code") {
  std::ifstream page(TENCER_DOCS "/scene.md");
  const std::string text{std::istreambuf_iterator<char>(page), {}};
  for (const model::Material& material : model::materials())
    CHECK_THAT(text, Catch::Contains("| `" + material.name + "` | " +
                                     number(material.youngs_modulus / 1e9) + " | " +
                                     number(*material.density) + " | " +
                                     number(100 * material.strain_limit) + " | " +
                                     number(100 * material.breaking_strain) + " |"));
}
