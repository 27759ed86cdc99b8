#include "curves/curve_vect.hpp"

#include <cstdlib>

#include "curves/finish_curve.hpp"
#include "text/bad_input.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

struct Word {
  std::string_view text;
  int line = 0;
};

// The words of the file in a row; lines mean nothing in it.
class Words {
 public:
  Words(std::string_view text, const std::string& file) : file_(file) {
    int number = 0;
    for (const std::string_view line : lines(text)) {
      ++number;
      for (const std::string_view word : words(line.substr(0, line.find('#'))))
        words_.push_back({word, number});
    }
  }

  Word next(const char* what) {
    if (at_ == words_.size())
      fail(file_, std::string("the file ends where ") + what + " should follow");
    return words_[at_++];
  }
  std::string where(const Word& word) const { return file_ + ":" + std::to_string(word.line); }

  long integer(const char* what) {
    const Word word = next(what);
    const auto number = to_integer(word.text);
    if (!number)
      fail(where(word), "expected " + std::string(what) + ", found " + quoted(word.text));
    return *number;
  }
  std::size_t left() const { return words_.size() - at_; }

 private:
  const std::string& file_;
  std::vector<Word> words_;
  std::size_t at_ = 0;
};

void read_header(Words& words) {
  Word word = words.next("VECT");
  if (word.text == "{") word = words.next("VECT");
  if (word.text == "4VECT")
    fail(
        words.where(word),
        "4VECT has points in four dimensions; project them and save the three coordinates as VECT");
  if (word.text == "VECT" || word.text == "{VECT") return;
  fail(words.where(word),
       "expected VECT, found " + quoted(word.text) + "; save the curve alone, as plain VECT");
}

// The points of each polyline; negative: it is closed.
std::vector<long> read_counts(Words& words, const std::string& file) {
  const long polylines = words.integer("the number of polylines");
  const long vertices = words.integer("the number of vertices");
  words.integer("the number of colours");
  if (polylines < 1 || static_cast<std::size_t>(polylines) > words.left())
    fail(file,
         "expected at least one polyline, and counts and vertices of each; the second line "
         "says " +
             std::to_string(polylines));
  std::vector<long> counts;
  long sum = 0;
  for (long i = 0; i < polylines; ++i) {
    counts.push_back(words.integer("the vertices of a polyline"));
    if (counts.back() == 0 || std::abs(counts.back()) > vertices)
      fail(file, "a polyline cannot have " + std::to_string(counts.back()) + " of " +
                     std::to_string(vertices) + " vertices");
    sum += std::abs(counts.back());
  }
  if (sum != vertices)
    fail(file, "the polylines have " + std::to_string(sum) +
                   " vertices, but the second line says " + std::to_string(vertices));
  for (long i = 0; i < polylines; ++i) words.integer("the colours of a polyline");
  return counts;
}

}  // namespace

CurveFile parse_vect(std::string_view text, const std::string& file) {
  Words words(text, file);
  read_header(words);
  CurveFile result;
  for (const long count : read_counts(words, file)) {
    ListedCurve curve;
    std::vector<std::string> places;
    for (long i = 0; i < std::abs(count); ++i) {
      Eigen::Vector3d point;
      for (double& number : point) {
        const Word word = words.next("a coordinate");
        if (&number == point.data()) places.push_back(words.where(word));
        number = coordinate(word.text, words.where(word));
      }
      curve.points.push_back(point);
    }
    curve.closed = count < 0 ? std::optional(true) : std::nullopt;
    curve.where = places.front();
    curve.where_of = [&](int i) { return places[i]; };
    curve.name_of = [](int i) { return "vertex " + std::to_string(i); };
    finish_curve(curve, result);
  }
  return result;
}

}  // namespace tencer::io
