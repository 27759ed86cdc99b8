#include "curves/curve_obj.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>

#include "curves/finish_curve.hpp"
#include "curves/join_ends.hpp"
#include "curves/pieces.hpp"
#include "text/bad_input.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

// An `l` element, several joined, or a face: indices from 0, and the line of the first.
struct Chain {
  std::vector<int> vertices;
  int line = 0;
};

// A `curv` element with the statements that belong to it.
struct FreeForm {
  std::string type = "bspline";
  bool rational = false;
  int degree = 0;
  double from = 0.0;
  double to = 1.0;
  std::vector<int> control;
  std::vector<double> knots;
  int line = 0;
};

struct Content {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<double> weights;  // the fourth coordinate, else 1
  std::vector<Chain> chains;
  std::vector<Chain> faces;
  FreeForm form;  // what the next `curv` is
  std::vector<FreeForm> free_forms;
};

using Fields = std::span<const std::string_view>;

// Keywords that say nothing about curves.
constexpr std::array<std::string_view, 16> ignored{
    "vt", "vn", "o",    "g",      "s",      "mg",  "p",          "end",
    "vp", "sp", "hole", "mtllib", "usemtl", "lod", "shadow_obj", "trace_obj"};

void parse_vertex(Fields fields, const std::string& where, Content& content) {
  if (fields.size() < 3)
    fail(where, "a vertex needs 3 coordinates, found " + std::to_string(fields.size()));
  content.vertices.emplace_back(coordinate(fields[0], where), coordinate(fields[1], where),
                                coordinate(fields[2], where));
  content.weights.push_back(fields.size() == 4 ? coordinate(fields[3], where) : 1.0);
}

int parse_index(std::string_view field, int vertices, const std::string& where) {
  const std::string_view first = field.substr(0, field.find('/'));  // i/texture
  const auto index = to_integer(first);
  if (!index) fail(where, quoted(field) + " is not a vertex index");
  if (*index == 0) fail(where, "vertex index 0: OBJ counts from 1");
  const long from_zero = *index > 0 ? *index - 1 : vertices + *index;
  if (from_zero < 0 || from_zero >= vertices)
    fail(where, "vertex index " + std::string(first) + " is out of range: " +
                    (vertices == 0 ? "there are no vertices before this line"
                                   : "use 1 to " + std::to_string(vertices) + ", or -1 to -" +
                                         std::to_string(vertices)));
  return static_cast<int>(from_zero);
}

std::vector<int> parse_indices(Fields fields, std::size_t fewest, const std::string& what,
                               const std::string& where, const Content& content) {
  std::vector<int> indices;
  for (const std::string_view field : fields)
    indices.push_back(parse_index(field, static_cast<int>(content.vertices.size()), where));
  if (indices.size() < fewest)
    fail(where, what + " needs at least " + std::to_string(fewest) + " vertex indices, found " +
                    std::to_string(indices.size()));
  return indices;
}

// One of the statements that make a free-form curve; false: it is none.
bool parse_free_form(std::string_view keyword, Fields rest, const std::string& where, int line,
                     Content& content) {
  FreeForm& form = content.form;
  if (keyword == "cstype") {
    form.rational = !rest.empty() && rest[0] == "rat";
    form.type = rest.empty() ? "" : std::string(rest.back());
    if (form.type != "bspline" && form.type != "bezier")
      fail(where, "a curve of type " + io::quoted(form.type) +
                      " is not read, only bspline and bezier; convert it to lines before export");
  } else if (keyword == "deg") {
    const auto degree = rest.empty() ? std::nullopt : to_integer(rest[0]);
    if (!degree || *degree < 1 || *degree > 25) fail(where, "expected a degree from 1 to 25");
    form.degree = static_cast<int>(*degree);
  } else if (keyword == "curv") {
    if (rest.size() < 2) fail(where, "a curve needs its range, curv u0 u1, and control points");
    form.from = coordinate(rest[0], where);
    form.to = coordinate(rest[1], where);
    form.control = parse_indices(rest.subspan(2), 2, "a curve", where, content);
    form.line = line;
    form.knots.clear();
    content.free_forms.push_back(form);
  } else if (keyword == "parm") {
    if (content.free_forms.empty()) fail(where, "these knots belong to no curve (curv)");
    if (rest.empty() || rest[0] != "u") fail(where, "expected parm u and the knots");
    for (const std::string_view field : rest.subspan(1))
      content.free_forms.back().knots.push_back(coordinate(field, where));
  } else if (keyword == "surf" || keyword == "curv2") {
    fail(where, "the file holds a surface (" + std::string(keyword) + "); export the curve alone");
  } else {
    return false;
  }
  return true;
}

// A line that goes on in the next one, where it ends with a backslash.
struct LogicalLine {
  std::string text;
  int number = 0;  // of its first line
};

std::vector<LogicalLine> logical_lines(std::string_view text) {
  std::vector<LogicalLine> result;
  int number = 0;
  bool goes_on = false;
  for (const std::string_view line : lines(text)) {
    ++number;
    if (!goes_on) result.push_back({.text = {}, .number = number});
    const std::string_view content = line.substr(0, line.find('#'));
    const std::size_t last = content.find_last_not_of(" \t");
    goes_on = last != std::string_view::npos && content[last] == '\\';
    result.back().text.append(content.substr(0, goes_on ? last : content.size())).append(1, ' ');
  }
  return result;
}

Content parse_lines(std::string_view text, const std::string& file) {
  Content content;
  for (const LogicalLine& line : logical_lines(text)) {
    const std::string where = file + ":" + std::to_string(line.number);
    const std::vector<std::string_view> fields = words(line.text);
    if (fields.empty()) continue;
    const Fields rest = Fields(fields).subspan(1);
    if (fields[0] == "v") {
      parse_vertex(rest, where, content);
    } else if (fields[0] == "l") {
      content.chains.push_back(
          {parse_indices(rest, 2, "a line element", where, content), line.number});
    } else if (fields[0] == "f") {
      content.faces.push_back({parse_indices(rest, 3, "a face", where, content), line.number});
    } else if (!parse_free_form(fields[0], rest, where, line.number, content) &&
               std::ranges::find(ignored, fields[0]) == ignored.end()) {
      fail(where, "unknown keyword " + quoted(fields[0]) +
                      "; curves are given by v (vertex) and l (line) elements");
    }
  }
  return content;
}

// Joins chains at shared end vertices.
std::vector<Chain> joined_chains(const std::vector<Chain>& chains, const std::string& file) {
  std::vector<PieceEnds> ends;
  for (const Chain& chain : chains) ends.push_back({chain.vertices.front(), chain.vertices.back()});
  const auto runs = join_ends(ends, [&](int piece, int vertex) {
    fail(file + ":" + std::to_string(chains[piece].line),
         "three line elements end at vertex " + std::to_string(vertex + 1) +
             "; a rod cannot branch, so give each rod its own vertices");
  });
  std::vector<Chain> result;
  for (const Run& run : runs) {
    Chain whole{{}, chains[run.parts.front().piece].line};
    for (const Run::Part& part : run.parts) {
      std::vector<int> more = chains[part.piece].vertices;
      if (part.reversed) std::ranges::reverse(more);
      whole.vertices.insert(whole.vertices.end(), more.begin() + (whole.vertices.empty() ? 0 : 1),
                            more.end());
    }
    result.push_back(std::move(whole));
  }
  return result;
}

// Faces that have no vertex in common are closed curves; others are a mesh.
std::vector<Chain> outlines(const std::vector<Chain>& faces, const std::string& file) {
  std::set<int> used;
  std::vector<Chain> result;
  for (Chain face : faces) {
    for (const int vertex : std::set<int>(face.vertices.begin(), face.vertices.end()))
      if (!used.insert(vertex).second)
        fail(file + ":" + std::to_string(face.line),
             "the file holds a mesh, faces that share vertices, and no curves; curves are given "
             "by l (line) elements, or each by one face of its own");
    face.vertices.push_back(face.vertices.front());
    result.push_back(std::move(face));
  }
  return result;
}

// A Bezier curve of several pieces is a B-spline whose knots between them are as many as the
// degree.
std::vector<double> bezier_knots(const FreeForm& form) {
  std::vector<double> knots;
  for (std::size_t i = 0; i < form.knots.size(); ++i) {
    const bool end = i == 0 || i + 1 == form.knots.size();
    knots.insert(knots.end(), form.degree + (end ? 1 : 0), form.knots[i]);
  }
  return knots;
}

std::vector<Eigen::Vector3d> points_of(const FreeForm& form, const Content& content,
                                       const std::string& where) {
  Nurbs spline{.degree = form.degree,
               .knots = form.type == "bezier" ? bezier_knots(form) : form.knots,
               .from = form.from,
               .to = form.to};
  spline.control.resize(3, static_cast<Eigen::Index>(form.control.size()));
  for (std::size_t i = 0; i < form.control.size(); ++i)
    spline.control.col(i) = content.vertices[form.control[i]];
  if (form.rational) {
    spline.weights.resize(spline.control.cols());
    for (std::size_t i = 0; i < form.control.size(); ++i)
      spline.weights[i] = content.weights[form.control[i]];
  }
  if (const char* wrong = problem(spline))
    fail(where, std::string("this curve cannot be drawn: ") + wrong);
  return points_along(pieces(spline));
}

void add_chains(const std::vector<Chain>& chains, const Content& content, const std::string& file,
                CurveFile& result) {
  for (const Chain& chain : chains) {
    const std::string where = chain.line > 0 ? file + ":" + std::to_string(chain.line) : file;
    ListedCurve curve;
    for (const int vertex : chain.vertices) curve.points.push_back(content.vertices[vertex]);
    curve.where = where;
    curve.where_of = [&](int) { return where; };
    curve.name_of = [&](int i) { return "vertex " + std::to_string(chain.vertices[i] + 1); };
    finish_curve(curve, result);
  }
}

void add_free_forms(const Content& content, const std::string& file, CurveFile& result) {
  for (const FreeForm& form : content.free_forms) {
    ListedCurve curve;
    curve.where = file + ":" + std::to_string(form.line);
    curve.points = points_of(form, content, curve.where);
    check_drawn(curve);
    curve.where_of = [&](int) { return curve.where; };
    curve.name_of = [](int i) { return "point " + std::to_string(i) + " along it"; };
    finish_curve(curve, result);
  }
}

}  // namespace

CurveFile parse_obj(std::string_view text, const std::string& file) {
  const Content content = parse_lines(text, file);
  if (content.vertices.empty()) fail(file, "the file holds no vertices (v x y z)");
  CurveFile result;
  const bool drawn = !content.chains.empty() || !content.free_forms.empty();
  if (drawn) {
    add_chains(joined_chains(content.chains, file), content, file, result);
    add_free_forms(content, file, result);
    if (!content.faces.empty())
      result.notes.push_back(file + ": faces beside the curves are left out, " +
                             std::to_string(content.faces.size()) + " of them");
  } else if (!content.faces.empty()) {
    add_chains(outlines(content.faces, file), content, file, result);
  } else {
    Chain all;
    for (int i = 0; i < static_cast<int>(content.vertices.size()); ++i) all.vertices.push_back(i);
    add_chains({all}, content, file, result);
  }
  return result;
}

}  // namespace tencer::io
