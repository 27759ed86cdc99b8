#include "plot.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace tencer::app::study {
namespace {

bool on_axes(const PlotPoint& point) { return point.seconds > 0 && point.error > 0; }

bool drawn(const PlotCurve& curve) { return std::ranges::any_of(curve.points, on_axes); }

// As gnuplot reads it: nothing but the quote itself has a meaning between single quotes.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

// A comment, or a field of a data file, in one line.
std::string plain(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r' || c == '"') c = ' ';
  return text;
}

std::string data(const Plot& plot) {
  std::ostringstream text;
  text << "# seconds, error, label; two blank lines between curves\n" << std::setprecision(9);
  bool first = true;
  for (const auto& curve : plot.curves) {
    if (!drawn(curve)) continue;
    text << (first ? "" : "\n\n") << "# " << plain(curve.name) << '\n';
    first = false;
    for (const auto& point : curve.points)
      if (on_axes(point))
        text << point.seconds << ' ' << point.error << " \"" << plain(point.label) << "\"\n";
  }
  return text.str();
}

// Numbers for an axis from `least` to `largest` and a little beyond: 1, 2 and 5 of each decade, or,
// within one, equal steps.
std::vector<double> numbers_along(double least, double largest) {
  std::vector<double> numbers;
  if (largest < 3 * least) {
    double step = std::pow(10.0, std::floor(std::log10(0.5 * least)));
    if (largest - least < 2 * step) step /= 5;
    for (double k = std::floor(0.7 * least / step); k * step < 1.4 * largest; ++k)
      numbers.push_back(k * step);
    return numbers;
  }
  const int last = static_cast<int>(std::ceil(std::log10(largest)));
  for (int decade = static_cast<int>(std::floor(std::log10(least))) - 1; decade <= last; ++decade)
    for (const int digit : {1, 2, 5}) numbers.push_back(digit * std::pow(10.0, decade));
  return numbers;
}

// Where fewer than two powers of ten may be on an axis, which would leave it without numbers; else
// gnuplot's own choice.
std::string tics(const Plot& plot, char axis, double PlotPoint::*value) {
  double least = std::numeric_limits<double>::infinity();
  double largest = 0;
  for (const auto& curve : plot.curves)
    for (const auto& point : curve.points)
      if (on_axes(point)) {
        least = std::min(least, point.*value);
        largest = std::max(largest, point.*value);
      }
  if (!(largest < 100 * least)) return "";
  std::ostringstream text;
  for (const double number : numbers_along(least, largest))
    text << (text.str().empty() ? "" : ", ") << number;
  return std::string("set ") + axis + "tics (" + text.str() + ")\n";
}

std::string script(const std::string& name, const Plot& plot) {
  std::ostringstream text;
  text << "# gnuplot " << plain(name) << ".gp\n"
       << "set terminal svg size 760,520 font 'sans,13' background rgb 'white'\n"
       << "set output " << quoted(name + ".svg") << '\n'
       << "set title " << quoted(plot.title) << " noenhanced\n"
       << "set logscale xy\nset format xy '%g'\nset grid lc rgb '#dddddd'\n"
       << "set xlabel "
       << quoted("seconds" + (plot.label_note.empty() ? "" : " (" + plot.label_note + ")"))
       << " noenhanced\nset ylabel " << quoted(plot.error_axis) << " noenhanced\n"
       << tics(plot, 'x', &PlotPoint::seconds) << tics(plot, 'y', &PlotPoint::error)
       << "set key outside below horizontal noenhanced\nset autoscale noextend\n"
       << "set offsets graph 0.05, graph 0.05, graph 0.1, graph 0.05\n"
       << "set linetype 1 lc rgb '#0060ad'\nset linetype 2 lc rgb '#d95319'\n"
       << "set linetype 3 lc rgb '#4f9d2f'\nset linetype 4 lc rgb '#7e2f8e'\n"
       << "set linetype 5 lc rgb '#a2842c'\nset linetype 6 lc rgb '#008b8b'\n"
       << "data = " << quoted(name + ".dat") << '\n';
  text << "plot";
  int block = 0;
  for (const auto& curve : plot.curves) {
    if (!drawn(curve)) continue;
    text << (block > 0 ? ", \\\n     " : " ") << "data index " << block
         << " using 1:2 with linespoints lt " << curve.colour << " pt 7 ps 0.45 title "
         << quoted(curve.name) << ", data index " << block
         << " using 1:2:3 with labels offset 0,0.7 font ',10' tc lt " << curve.colour << " notitle";
    ++block;
  }
  text << '\n';
  return text.str();
}

}  // namespace

bool has_points(const Plot& plot) { return std::ranges::any_of(plot.curves, drawn); }

std::vector<io::NamedText> plot_files(const std::string& name, const Plot& plot) {
  return {{name + ".dat", data(plot)}, {name + ".gp", script(name, plot)}};
}

}  // namespace tencer::app::study
