// PolyData of VTK in XML, for ParaView: https://docs.vtk.org, "VTK XML file formats".
#include <array>
#include <limits>
#include <pugixml.hpp>
#include <span>
#include <sstream>
#include <tencer/model/vertex_fields.hpp>

#include "export/parts.hpp"
#include "export/writers.hpp"
#include "text/bytes.hpp"

namespace tencer::io {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

// What is known at the points of all parts, in their order.
struct PointData {
  std::vector<double> points{};     // three a point, and so of the deviation
  std::vector<double> deviation{};  // as a vector
  std::vector<double> curvature{};
  std::vector<double> strain{};
  std::vector<double> tension{};
  bool any_strain = false;

  void add(const Eigen::Vector3d& point, const Eigen::Vector3d& off, double curve, double bend,
           double pull) {
    points.insert(points.end(), point.begin(), point.end());
    deviation.insert(deviation.end(), off.begin(), off.end());
    curvature.push_back(curve);
    strain.push_back(bend);
    tension.push_back(pull);
  }
};

// By how much the end of a cable is off: as the rod is there.
Eigen::Vector3d deviation_at(const springs::End& end, const std::vector<geometry::ArcLength>& arcs,
                             const std::vector<model::VertexFields>& fields) {
  const auto* on = std::get_if<springs::OnRod>(&end);
  if (on == nullptr) return Eigen::Vector3d::Zero();
  const auto [edge, t] = arcs[on->rod].locate(on->s);
  const Eigen::Matrix3Xd& deviation = fields[on->rod].deviation;
  return (1 - t) * deviation.col(edge) + t * deviation.col((edge + 1) % deviation.cols());
}

PointData point_data(const model::Design& design, const std::vector<Part>& parts) {
  const auto fields = model::vertex_fields(design);
  const auto arcs = model::arc_lengths(design.structure);
  PointData data;
  for (const Part& part : parts)
    for (int i = 0; i < part.line.vertices(); ++i) {
      const Eigen::Vector3d point = part.line.points.col(i);
      if (part.kind == PartKind::rod) {
        const model::VertexFields& field = fields[part.index];
        data.any_strain = data.any_strain || field.strain;
        data.add(point, field.deviation.col(i), field.curvature[i],
                 field.strain ? (*field.strain)[i] : not_known, field.tension[i]);
      } else if (part.kind == PartKind::cable) {
        const springs::Cable& cable = design.structure.cables[part.index];
        data.add(point, deviation_at(i == 0 ? cable.a : cable.b, arcs, fields), 0, 0,
                 design.built[part.index].tension);
      } else {
        data.add(point, Eigen::Vector3d::Zero(), 0, 0, 0);
      }
    }
  return data;
}

// Binary, in which a value can also be "not known".
template <class Number>
void add_array(pugi::xml_node parent, const char* type, const char* name,
               std::span<const Number> values, int components = 1) {
  std::string bytes;
  for (const Number value : values) append_bytes(bytes, value);
  std::string size;
  append_bytes(size, static_cast<std::uint64_t>(bytes.size()));
  pugi::xml_node array = parent.append_child("DataArray");
  array.append_attribute("type") = type;
  array.append_attribute("Name") = name;
  array.append_attribute("NumberOfComponents") = components;
  array.append_attribute("format") = "binary";
  array.text() = (base64(size) + base64(bytes)).c_str();
}

void add_doubles(pugi::xml_node parent, const char* name, const std::vector<double>& values,
                 int components = 1) {
  add_array<double>(parent, "Float64", name, values, components);
}

// As VTK writes them: the codes of the letters, with a 0 after each word.
void add_words(pugi::xml_node parent, const char* name, const std::vector<std::string>& words) {
  std::string codes;
  for (const std::string& word : words) {
    for (const char c : word) codes += std::to_string(static_cast<unsigned char>(c)) + " ";
    codes += "0 ";
  }
  pugi::xml_node array = parent.append_child("DataArray");
  array.append_attribute("type") = "String";
  array.append_attribute("Name") = name;
  array.append_attribute("NumberOfTuples") = static_cast<unsigned>(words.size());
  array.append_attribute("format") = "ascii";
  array.text() = codes.c_str();
}

// The cells of a kind: where the points of each begin is `first`.
void add_cells(pugi::xml_node piece, const char* name, const std::vector<Part>& parts,
               const std::vector<std::int64_t>& first, bool points) {
  std::vector<std::int64_t> connectivity;
  std::vector<std::int64_t> offsets;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if ((parts[p].kind == PartKind::anchor) != points) continue;
    const int n = parts[p].line.vertices();
    for (int i = 0; i < n + (parts[p].line.closed ? 1 : 0); ++i)
      connectivity.push_back(first[p] + i % n);
    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
  }
  pugi::xml_node cells = piece.append_child(name);
  add_array<std::int64_t>(cells, "Int64", "connectivity", connectivity);
  add_array<std::int64_t>(cells, "Int64", "offsets", offsets);
}

// Points come before lines among cells, whatever the order in the file.
void add_cell_data(pugi::xml_node piece, const std::vector<Part>& parts) {
  std::vector<std::int32_t> kinds;
  std::vector<std::string> names;
  for (const bool points : {true, false})
    for (const Part& part : parts)
      if ((part.kind == PartKind::anchor) == points) {
        kinds.push_back(static_cast<std::int32_t>(part.kind));
        names.push_back(part.name);
      }
  pugi::xml_node data = piece.append_child("CellData");
  add_array<std::int32_t>(data, "Int32", "kind", kinds);
  add_words(data, "name", names);
}

pugi::xml_node add_piece(pugi::xml_node poly_data, std::size_t points, std::size_t anchors,
                         std::size_t lines) {
  pugi::xml_node piece = poly_data.append_child("Piece");
  const std::array<std::pair<const char*, std::size_t>, 5> counts{{{"NumberOfPoints", points},
                                                                   {"NumberOfVerts", anchors},
                                                                   {"NumberOfLines", lines},
                                                                   {"NumberOfStrips", 0},
                                                                   {"NumberOfPolys", 0}}};
  for (const auto& [name, count] : counts)
    piece.append_attribute(name) = static_cast<unsigned>(count);
  return piece;
}

}  // namespace

std::string vtp_text(const model::Design& design) {
  const std::vector<Part> parts = parts_of(design);
  const PointData data = point_data(design, parts);
  std::vector<std::int64_t> first;
  std::int64_t count = 0;
  for (const Part& part : parts) {
    first.push_back(count);
    count += part.line.vertices();
  }
  pugi::xml_document document;
  pugi::xml_node file = document.append_child("VTKFile");
  file.append_attribute("type") = "PolyData";
  file.append_attribute("version") = "1.0";
  file.append_attribute("byte_order") = "LittleEndian";
  file.append_attribute("header_type") = "UInt64";
  pugi::xml_node poly_data = file.append_child("PolyData");
  pugi::xml_node field_data = poly_data.append_child("FieldData");
  add_words(field_data, "length_unit", {design.length_unit});
  add_words(field_data, "force_unit", {design.force_unit});
  const auto anchors = static_cast<std::size_t>(design.structure.anchors.cols());
  pugi::xml_node piece = add_piece(poly_data, first.empty() ? 0 : static_cast<std::size_t>(count),
                                   anchors, parts.size() - anchors);
  pugi::xml_node point_values = piece.append_child("PointData");
  add_doubles(point_values, "deviation", data.deviation, 3);
  add_doubles(point_values, "curvature", data.curvature);
  if (data.any_strain) add_doubles(point_values, "bending_strain", data.strain);
  add_doubles(point_values, "tension", data.tension);
  add_cell_data(piece, parts);
  add_doubles(piece.append_child("Points"), "points", data.points, 3);
  add_cells(piece, "Verts", parts, first, true);
  add_cells(piece, "Lines", parts, first, false);
  std::ostringstream text;
  document.save(text, " ");
  return text.str();
}

}  // namespace tencer::io
