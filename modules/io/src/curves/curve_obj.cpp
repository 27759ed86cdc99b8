#include "curves/curve_obj.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <span>

#include "curves/finish_curve.hpp"
#include "text/bad_input.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

// An `l` element, or several joined: indices from 0, and the line of the first.
struct Chain {
  std::vector<int> vertices;
  int line = 0;

  bool closed() const { return vertices.size() > 1 && vertices.front() == vertices.back(); }
};

struct Content {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Chain> chains;
  std::optional<int> face_line;
};

// Keywords that say nothing about curves.
constexpr std::array<std::string_view, 11> ignored{"vt", "vn", "vp",     "o",      "g",  "s",
                                                   "mg", "p",  "mtllib", "usemtl", "lod"};

Eigen::Vector3d parse_vertex(std::span<const std::string_view> fields, const std::string& where) {
  if (fields.size() < 3)
    fail(where, "a vertex needs 3 coordinates, found " + std::to_string(fields.size()));
  return {coordinate(fields[0], where), coordinate(fields[1], where), coordinate(fields[2], where)};
}

int parse_index(std::string_view field, int vertices, const std::string& where) {
  const std::string_view first = field.substr(0, field.find('/'));  // i/texture
  const auto index = to_integer(first);
  if (!index) fail(where, quoted(field) + " is not a vertex index");
  const long from_zero = *index > 0 ? *index - 1 : vertices + *index;
  if (*index == 0 || from_zero < 0 || from_zero >= vertices)
    fail(where, "vertex index " + std::string(first) + " is out of range: " +
                    (vertices == 0 ? "there are no vertices before this line"
                                   : "use 1 to " + std::to_string(vertices) + ", or -1 to -" +
                                         std::to_string(vertices)));
  return static_cast<int>(from_zero);
}

// Keywords of curves that are given by control points.
constexpr std::array<std::string_view, 6> free_form{"cstype", "deg",  "curv",
                                                    "curv2",  "surf", "parm"};

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
    const int number = line.number;
    const std::string where = file + ":" + std::to_string(number);
    const std::vector<std::string_view> fields = words(line.text);
    if (fields.empty()) continue;
    const std::span<const std::string_view> rest = std::span(fields).subspan(1);
    if (fields[0] == "v") {
      content.vertices.push_back(parse_vertex(rest, where));
    } else if (fields[0] == "l") {
      Chain chain{{}, number};
      for (const std::string_view field : rest)
        chain.vertices.push_back(
            parse_index(field, static_cast<int>(content.vertices.size()), where));
      if (chain.vertices.size() < 2)
        fail(where, "a line element needs at least 2 vertex indices, found " +
                        std::to_string(chain.vertices.size()));
      content.chains.push_back(chain);
    } else if (fields[0] == "f") {
      content.face_line = content.face_line.value_or(number);
    } else if (std::ranges::find(free_form, fields[0]) != free_form.end()) {
      fail(where,
           "the file holds a free-form curve (" + std::string(fields[0]) +
               "), of which control points are known and not the curve; convert it to a mesh "
               "before export (in Blender: Object, Convert, Mesh), so that it has l (line) "
               "elements");
    } else if (std::ranges::find(ignored, fields[0]) == ignored.end()) {
      fail(where, "unknown keyword " + quoted(fields[0]) +
                      "; curves are given by v (vertex) and l (line) elements");
    }
  }
  return content;
}

// Joins chains at shared end vertices. The result keeps the order and the direction of each
// curve's first element.
std::vector<Chain> join(const std::vector<Chain>& chains, const std::string& file) {
  std::map<int, std::vector<int>> ends;  // vertex -> the open chains that end there
  for (int i = 0; i < static_cast<int>(chains.size()); ++i) {
    if (chains[i].closed()) continue;
    for (const int vertex : {chains[i].vertices.front(), chains[i].vertices.back()}) {
      ends[vertex].push_back(i);
      if (ends[vertex].size() > 2)
        fail(file + ":" + std::to_string(chains[i].line),
             "three line elements end at vertex " + std::to_string(vertex + 1) +
                 "; a rod cannot branch, so give each rod its own vertices");
    }
  }
  std::vector<bool> taken(chains.size(), false);
  const auto extend = [&](Chain& chain) {
    while (!chain.closed()) {
      const int end = chain.vertices.back();
      const auto next =
          std::ranges::find_if(ends[end], [&](int candidate) { return !taken[candidate]; });
      if (next == ends[end].end()) return;
      taken[*next] = true;
      std::vector<int> more = chains[*next].vertices;
      if (more.front() != end) std::ranges::reverse(more);
      chain.vertices.insert(chain.vertices.end(), more.begin() + 1, more.end());
    }
  };
  std::vector<Chain> result;
  for (int i = 0; i < static_cast<int>(chains.size()); ++i) {
    if (taken[i]) continue;
    taken[i] = true;
    Chain chain = chains[i];
    extend(chain);
    std::ranges::reverse(chain.vertices);
    extend(chain);
    std::ranges::reverse(chain.vertices);
    result.push_back(std::move(chain));
  }
  return result;
}

}  // namespace

CurveFile parse_obj(std::string_view text, const std::string& file) {
  const Content content = parse_lines(text, file);
  std::vector<Chain> chains = join(content.chains, file);
  if (chains.empty() && content.face_line)
    fail(file + ":" + std::to_string(*content.face_line),
         "the file holds faces but no curves; curves are given by l (line) elements");
  if (chains.empty()) {
    if (content.vertices.empty()) fail(file, "the file holds no vertices (v x y z)");
    Chain all;
    for (int i = 0; i < static_cast<int>(content.vertices.size()); ++i) all.vertices.push_back(i);
    chains.push_back(std::move(all));
  }
  CurveFile result;
  for (const Chain& chain : chains) {
    const std::string where = chain.line > 0 ? file + ":" + std::to_string(chain.line) : file;
    ListedCurve curve;
    for (const int vertex : chain.vertices) curve.points.push_back(content.vertices[vertex]);
    curve.where = where;
    curve.where_of = [&](int) { return where; };
    curve.name_of = [&](int i) { return "vertex " + std::to_string(chain.vertices[i] + 1); };
    result.curves.push_back(finish_curve(curve, result.notes));
  }
  return result;
}

}  // namespace tencer::io
