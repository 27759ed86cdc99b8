// glTF 2.0: https://registry.khronos.org/glTF/specs/2.0. A node a part, each with a surface of its
// own.
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <tencer/geometry/measure.hpp>
#include <tencer/geometry/smooth.hpp>
#include <tencer/model/units.hpp>

#include "design/pretty_json.hpp"
#include "export/parts.hpp"
#include "export/tube.hpp"
#include "export/writers.hpp"
#include "text/bytes.hpp"

namespace tencer::io {
namespace {

using Json = nlohmann::ordered_json;

// Of OpenGL, as glTF has them.
constexpr int float_type = 5126;
constexpr int index_type = 5125;
constexpr int vertex_buffer = 34962;
constexpr int index_buffer = 34963;

// Edges of rods are drawn in so many pieces that there are about `enough`.
int pieces_of(const geometry::Polyline& line) {
  constexpr int enough = 300;
  return std::max(1, (enough + line.edges() - 1) / line.edges());
}

// At every vertex of the smooth line where the section's first axis points; none when not known.
Eigen::Matrix3Xd axes_of(const Eigen::Matrix3Xd& directors, const geometry::Polyline& smooth,
                         int pieces) {
  if (directors.cols() == 0) return directors;
  Eigen::Matrix3Xd axes(3, smooth.vertices());
  for (int i = 0; i < smooth.vertices(); ++i) {
    // An edge's axis is that of its middle.
    const double at = static_cast<double>(i) / pieces - 0.5;
    const auto edges = static_cast<int>(directors.cols());
    const auto edge = static_cast<int>(std::floor(at));
    const auto column = [&](int e) -> Eigen::Vector3d {
      return directors.col(smooth.closed ? (e + edges) % edges : std::clamp(e, 0, edges - 1));
    };
    const Eigen::Vector3d before = column(edge);
    Eigen::Vector3d after = column(edge + 1);
    if (before.dot(after) < 0) after = -after;  // glued by half a turn
    axes.col(i) = before + (at - edge) * (after - before);
  }
  return axes;
}

// How thick things are drawn, in the design's unit.
class Shapes {
 public:
  explicit Shapes(const model::Design& design, const std::vector<Part>& parts) : design_(design) {
    constexpr double seen = 0.004;  // of the size, where no section is known
    std::vector<geometry::Polyline> lines;
    for (const Part& part : parts) lines.push_back(part.line);
    thin_ = seen * geometry::bounding_box_diagonal(lines);
    for (const der::Rod& rod : design.structure.rods)
      if (const auto half = der::half_sizes(rod.section.shape))
        thin_ = std::min({thin_, half->along_m1, half->along_m2});
  }

  Mesh mesh(const Part& part) const {
    if (part.kind == PartKind::anchor) return cube(part.line.points.col(0), 6 * thin_);
    if (part.kind == PartKind::cable)
      return tube(part.line, round_outline(0.4 * thin_), Eigen::Matrix3Xd(3, 0));
    const int pieces = pieces_of(part.line);
    const geometry::Polyline smooth = geometry::smoothed(part.line, pieces);
    const der::Shape& shape = design_.structure.rods[part.index].section.shape;
    if (const auto* flat = std::get_if<der::Rectangle>(&shape))
      return tube(smooth, rectangle_outline(flat->width, flat->height),
                  axes_of(design_.pose_directors[part.index], smooth, pieces));
    const auto half = der::half_sizes(shape);
    return tube(smooth, round_outline(half ? half->along_m1 : thin_), Eigen::Matrix3Xd(3, 0));
  }

 private:
  const model::Design& design_;
  double thin_ = 0.0;
};

// The document and the numbers that it refers to.
struct Gltf {
  Json json{};
  std::string numbers{};
};

// Where the last numbers from `from` on are, as an accessor. Returns its index.
int add_accessor(Gltf& gltf, std::size_t from, int component, const char* type, std::size_t count,
                 int target) {
  Json& views = gltf.json["bufferViews"];
  views.push_back({{"buffer", 0},
                   {"byteOffset", from},
                   {"byteLength", gltf.numbers.size() - from},
                   {"target", target}});
  Json& accessors = gltf.json["accessors"];
  accessors.push_back({{"bufferView", views.size() - 1},
                       {"componentType", component},
                       {"count", count},
                       {"type", type}});
  return static_cast<int>(accessors.size()) - 1;
}

int add_vectors(Gltf& gltf, const std::vector<Eigen::Vector3d>& vectors, double factor,
                bool bounds) {
  const std::size_t from = gltf.numbers.size();
  Eigen::Vector3f least = Eigen::Vector3f::Constant(std::numeric_limits<float>::max());
  Eigen::Vector3f most = -least;
  for (const Eigen::Vector3d& vector : vectors) {
    const Eigen::Vector3f value = (factor * vector).cast<float>();
    least = least.cwiseMin(value);
    most = most.cwiseMax(value);
    for (const float number : value) append_bytes(gltf.numbers, number);
  }
  const int accessor = add_accessor(gltf, from, float_type, "VEC3", vectors.size(), vertex_buffer);
  if (bounds) {
    gltf.json["accessors"][accessor]["min"] = {least.x(), least.y(), least.z()};
    gltf.json["accessors"][accessor]["max"] = {most.x(), most.y(), most.z()};
  }
  return accessor;
}

Json primitive(Gltf& gltf, const Mesh& mesh, double metres, int material) {
  const int points = add_vectors(gltf, mesh.points, metres, true);
  const int normals = add_vectors(gltf, mesh.normals, 1, false);
  const std::size_t from = gltf.numbers.size();
  for (const std::uint32_t corner : mesh.corners) append_bytes(gltf.numbers, corner);
  const int corners =
      add_accessor(gltf, from, index_type, "SCALAR", mesh.corners.size(), index_buffer);
  return {{"attributes", {{"POSITION", points}, {"NORMAL", normals}}},
          {"indices", corners},
          {"material", material}};
}

Json material(const char* name, double red, double green, double blue) {
  return {{"name", name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {red, green, blue, 1.0}},
            {"metallicFactor", 0.0},
            {"roughnessFactor", 0.6}}}};
}

Gltf gltf_of(const model::Design& design) {
  const std::vector<Part> parts = parts_of(design);
  const Shapes shapes(design, parts);
  const double metres = model::metres(design.length_unit);
  const double quarter = std::numbers::sqrt2 / 2;
  Gltf gltf;
  Json& json = gltf.json;
  json["asset"] = {{"version", "2.0"}, {"generator", "tencer"}};
  json["scene"] = 0;
  json["scenes"] = Json::array({{{"nodes", {0}}}});
  // The design's z is up, glTF's y.
  json["nodes"] = Json::array({{{"name", design.name.empty() ? "design" : design.name},
                                {"rotation", {-quarter, 0.0, 0.0, quarter}},
                                {"children", Json::array()}}});
  // All keys first: a new one moves what the others hold.
  for (const char* key : {"meshes", "accessors", "bufferViews", "buffers"})
    json[key] = Json::array();
  // In the order of PartKind.
  json["materials"] = {material("rod", 0.05, 0.20, 0.55), material("cable", 0.69, 0.06, 0.01),
                       material("anchor", 0.15, 0.18, 0.22)};
  for (const Part& part : parts) {
    json["meshes"].push_back(
        {{"name", part.name},
         {"primitives",
          Json::array({primitive(gltf, shapes.mesh(part), metres, static_cast<int>(part.kind))})}});
    json["nodes"][0]["children"].push_back(json["nodes"].size());
    json["nodes"].push_back({{"name", part.name}, {"mesh", json["meshes"].size() - 1}});
  }
  const Json buffer = {{"byteLength", gltf.numbers.size()}};
  json["buffers"].push_back(buffer);
  return gltf;
}

// Chunks of a binary file are a multiple of four bytes long.
void add_chunk(std::string& bytes, std::uint32_t type, std::string content, char filling) {
  content.resize((content.size() + 3) / 4 * 4, filling);
  append_bytes(bytes, static_cast<std::uint32_t>(content.size()));
  append_bytes(bytes, type);
  bytes += content;
}

}  // namespace

std::string gltf_text(const model::Design& design) {
  Gltf gltf = gltf_of(design);
  gltf.json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(gltf.numbers);
  return pretty(gltf.json);
}

std::string glb_bytes(const model::Design& design) {
  constexpr std::uint32_t magic = 0x46546C67;  // "glTF"
  constexpr std::uint32_t version = 2;
  constexpr std::uint32_t json_chunk = 0x4E4F534A;    // "JSON"
  constexpr std::uint32_t binary_chunk = 0x004E4942;  // "BIN"
  constexpr std::uint32_t header = 12;
  Gltf gltf = gltf_of(design);
  std::string chunks;
  add_chunk(chunks, json_chunk, gltf.json.dump(), ' ');
  add_chunk(chunks, binary_chunk, std::move(gltf.numbers), '\0');
  std::string bytes;
  append_bytes(bytes, magic);
  append_bytes(bytes, version);
  append_bytes(bytes, static_cast<std::uint32_t>(header + chunks.size()));
  return bytes + chunks;
}

}  // namespace tencer::io
