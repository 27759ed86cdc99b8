#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>
#include <tencer/io/curve.hpp>
#include <tencer/io/export.hpp>
#include <tencer/model/cable_lines.hpp>
#include <tencer/model/vertex_fields.hpp>

#include "sample_design.hpp"

using namespace tencer;
using io::ExportFormat;

namespace {

// The sample with a section that is known on its first rod, a round one.
model::Design sectioned() {
  model::Design design = sample();
  design.structure.rods[0].section = der::solid_circle(1e3, 0.3, 0.02);
  design.structure.rods[1].section = der::solid_circle(1e3, 0.3, 0.02);
  return design;
}

std::vector<geometry::Polyline> read_back(const std::string& name, const std::string& text) {
  const auto path = std::filesystem::temp_directory_path() / name;
  std::ofstream(path, std::ios::binary) << text;
  const auto read = io::read_curve_file(path);
  std::filesystem::remove(path);
  INFO((read ? "" : read.error().text()));
  REQUIRE(read);
  return read->curves;
}

std::string unbase64(std::string_view text) {
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const std::string_view letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const auto at = letters.find(c);
    if (at == std::string_view::npos) break;
    bits = bits << 6 | static_cast<std::uint32_t>(at);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>(bits >> count & 0xFF);
    }
  }
  return bytes;
}

template <class Number>
std::vector<Number> numbers_in(std::string_view bytes) {
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
  return numbers;
}

// An array of a VTP file: its size in 8 bytes, which are 12 letters, and its numbers.
template <class Number>
std::vector<Number> vtp_array(const pugi::xml_node& parent, const char* name) {
  const pugi::xml_node array = parent.find_child_by_attribute("DataArray", "Name", name);
  REQUIRE(array);
  const std::string_view text = array.text().get();
  const auto size = numbers_in<std::uint64_t>(unbase64(text.substr(0, 12)));
  const std::string bytes = unbase64(text.substr(12));
  REQUIRE(size == std::vector<std::uint64_t>{bytes.size()});
  return numbers_in<Number>(bytes);
}

}  // namespace

TEST_CASE("the format of an export goes by the ending of its name") {
  CHECK(io::export_format("a/b.OBJ") == ExportFormat::obj);
  CHECK(io::export_format("knot.vtp") == ExportFormat::vtp);
  CHECK(io::export_format("knot.glb") == ExportFormat::glb);
  CHECK_FALSE(io::export_format("knot.stl"));
  CHECK_FALSE(io::export_format("obj"));
}

TEST_CASE("an exported OBJ holds an object a rod, a cable and an anchor") {
  const model::Design design = sample();
  std::istringstream text(io::export_text(design, ExportFormat::obj));
  std::vector<std::string> objects;
  std::vector<std::string> elements;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("o ")) objects.push_back(line.substr(2));
    if (line.starts_with("l ") || line.starts_with("p ")) elements.push_back(line);
  }
  CHECK(objects ==
        std::vector<std::string>{"rod_A", "rod_B", "cable_1", "cable_2", "anchor_1", "anchor_2"});
  CHECK(elements ==
        std::vector<std::string>{"l 1 2 3 4 1", "l 5 6 7", "l 8 9", "l 10 11", "p 12", "p 13"});
  const auto curves = read_back("tencer_export.obj", io::export_text(design, ExportFormat::obj));
  REQUIRE(curves.size() == 4);
  CHECK(curves[0].points == design.pose[0]);
  CHECK(curves[3].points == model::cable_lines(design)[1].points);
}

TEST_CASE("an exported DXF reads back in its unit, closed rods closed") {
  const model::Design design = sample();
  const auto path = std::filesystem::temp_directory_path() / "tencer_export.dxf";
  std::ofstream(path) << io::export_text(design, ExportFormat::dxf);
  const auto read = io::read_curve_file(path);
  std::filesystem::remove(path);
  REQUIRE(read);
  CHECK(read->length_unit == "mm");
  REQUIRE_FALSE(read->curves.empty());
  CHECK(read->curves[0].closed);
  CHECK(read->curves[0].points == design.pose[0]);
  CHECK(io::export_text(design, ExportFormat::dxf).find("\nROD_A\n") != std::string::npos);
  CHECK(io::export_text(design, ExportFormat::dxf).find("\nCABLE_2\n") != std::string::npos);
}

TEST_CASE("an exported table is a curve file, with what is known of each vertex") {
  const model::Design design = sectioned();
  const std::string text = io::export_text(design, ExportFormat::csv);
  const auto curves = read_back("tencer_export.csv", text);
  REQUIRE(curves.size() == 2);
  for (std::size_t r = 0; r < 2; ++r) {
    CHECK(curves[r].closed == design.structure.rods[r].closed);
    CHECK(curves[r].points == design.pose[r]);
  }
  CHECK(
      text.starts_with("rod,vertex,s (mm),x (mm),y (mm),z (mm),deviation (mm),"
                       "curvature (1/mm),bending_strain,tension ("));
}

TEST_CASE("an exported VTP holds its fields at the points, the cables' tensions among them") {
  const model::Design design = sectioned();
  pugi::xml_document document;
  REQUIRE(document.load_string(io::export_text(design, ExportFormat::vtp).c_str()));
  const pugi::xml_node piece = document.child("VTKFile").child("PolyData").child("Piece");
  // 4 and 3 vertices, two ends of each of two cables, two anchors.
  REQUIRE(piece.attribute("NumberOfPoints").as_int() == 13);
  CHECK(piece.attribute("NumberOfVerts").as_int() == 2);
  CHECK(piece.attribute("NumberOfLines").as_int() == 4);
  const auto points = vtp_array<double>(piece.child("Points"), "points");
  CHECK(points[3 * 5 + 1] == design.pose[1](1, 1));
  const auto connectivity = vtp_array<std::int64_t>(piece.child("Lines"), "connectivity");
  CHECK(connectivity == std::vector<std::int64_t>{0, 1, 2, 3, 0, 4, 5, 6, 7, 8, 9, 10});
  CHECK(vtp_array<std::int64_t>(piece.child("Lines"), "offsets") ==
        std::vector<std::int64_t>{5, 8, 10, 12});

  const auto fields = model::vertex_fields(design);
  const pugi::xml_node data = piece.child("PointData");
  const auto tension = vtp_array<double>(data, "tension");
  CHECK(tension[1] == fields[0].tension[1]);
  CHECK(tension[9] == design.built[1].tension);
  CHECK(tension[10] == design.built[1].tension);
  CHECK(vtp_array<double>(data, "curvature")[2] == fields[0].curvature[2]);
  CHECK(vtp_array<double>(data, "deviation")[3 * 4 + 2] == fields[1].deviation(2, 0));
  // The first cable begins at the seam of the closed rod.
  CHECK(vtp_array<double>(data, "deviation")[3 * 7] == Approx(fields[0].deviation(0, 0)));
  // At the anchors come first.
  CHECK(vtp_array<std::int32_t>(piece.child("CellData"), "kind") ==
        std::vector<std::int32_t>{2, 2, 0, 0, 1, 1});
}

TEST_CASE("a strain that is not known of any rod is left out of a VTP") {
  pugi::xml_document document;
  REQUIRE(document.load_string(io::export_text(sample(), ExportFormat::vtp).c_str()));
  const pugi::xml_node data =
      document.child("VTKFile").child("PolyData").child("Piece").child("PointData");
  CHECK_FALSE(data.find_child_by_attribute("DataArray", "Name", "bending_strain"));
}

TEST_CASE("an exported glTF has a node a part, in metres, as thick as the section") {
  const model::Design design = sectioned();
  const auto json = nlohmann::json::parse(io::export_text(design, ExportFormat::gltf));
  const auto& nodes = json.at("nodes");
  REQUIRE(nodes.size() == 7);
  CHECK(nodes[1].at("name") == "rod A");
  CHECK(nodes[4].at("name") == "cable 2");
  CHECK(nodes[6].at("name") == "anchor 2");
  const std::string prefix = "data:application/octet-stream;base64,";
  const std::string uri = json.at("buffers")[0].at("uri");
  const std::string bytes = unbase64(std::string_view(uri).substr(prefix.size()));
  REQUIRE(bytes.size() == json.at("buffers")[0].at("byteLength"));

  // Every vertex of the open rod's surface is a radius, 0.02 mm, away from its line.
  const auto& mesh = json.at("meshes")[1].at("primitives")[0];
  const auto& points = json.at("accessors")[mesh.at("attributes").at("POSITION").get<int>()];
  const auto& view = json.at("bufferViews")[points.at("bufferView").get<int>()];
  const auto numbers = numbers_in<float>(std::string_view(bytes).substr(
      view.at("byteOffset").get<std::size_t>(), view.at("byteLength").get<std::size_t>()));
  REQUIRE(numbers.size() == 3 * points.at("count").get<std::size_t>());
  const Eigen::Vector3d start = design.pose[1].col(0) * 1e-3;
  double nearest = 1;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    nearest = std::min(
        nearest, (Eigen::Vector3d(numbers[i], numbers[i + 1], numbers[i + 2]) - start).norm());
  CHECK(nearest == Approx(0.02e-3).epsilon(1e-3));
  // Corners name vertices that there are.
  const auto& corners = json.at("accessors")[mesh.at("indices").get<int>()];
  const auto& index_view = json.at("bufferViews")[corners.at("bufferView").get<int>()];
  const auto indices = numbers_in<std::uint32_t>(
      std::string_view(bytes).substr(index_view.at("byteOffset").get<std::size_t>(),
                                     index_view.at("byteLength").get<std::size_t>()));
  REQUIRE(indices.size() % 3 == 0);
  CHECK(*std::max_element(indices.begin(), indices.end()) ==
        points.at("count").get<std::uint32_t>() - 1);
}

TEST_CASE("a binary glTF says its sizes") {
  const std::string bytes = io::export_text(sample(), ExportFormat::glb);
  REQUIRE(bytes.substr(0, 4) == "glTF");
  const auto sizes = numbers_in<std::uint32_t>(std::string_view(bytes).substr(4, 16));
  CHECK(sizes[0] == 2);
  CHECK(sizes[1] == bytes.size());
  CHECK(sizes[2] % 4 == 0);
  const auto json = nlohmann::json::parse(bytes.substr(20, sizes[2]));
  CHECK(json.at("buffers")[0].count("uri") == 0);
}
