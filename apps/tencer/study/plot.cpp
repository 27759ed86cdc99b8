#include "plot.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>

#include "table.hpp"

namespace tencer::app::study {
namespace {

bool on_axes(const PlotPoint& point) {
  return point.seconds > 0 && (point.error > 0 || point.count > 0);
}

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
  const auto or_none = [](double value) {
    std::ostringstream number;
    number << std::setprecision(9) << value;
    return value > 0 ? number.str() : std::string("nan");
  };
  text << "# seconds, error, " << plain(plot.count_axis) << "; two blank lines between curves\n";
  bool first = true;
  for (const auto& curve : plot.curves) {
    if (!drawn(curve)) continue;
    text << (first ? "" : "\n\n") << "# " << plain(curve.name) << '\n';
    first = false;
    for (const auto& point : curve.points)
      if (on_axes(point))
        text << or_none(point.seconds) << ' ' << or_none(point.error) << ' ' << or_none(point.count)
             << '\n';
  }
  return text.str();
}

// Numbers for an axis from `least` to `largest` and a little beyond: 1, 2 and 5 of each decade, or,
// within one, equal steps.
std::vector<double> numbers_along(double least, double largest, double least_step) {
  std::vector<double> numbers;
  if (largest < 3 * least) {
    double step = std::pow(10.0, std::floor(std::log10(0.5 * least)));
    if (largest - least < 2 * step) step /= 5;
    step = std::max(step, least_step);
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
std::string tics(char axis, std::vector<double> values, double least_step = 0.0) {
  std::erase_if(values, [](double value) { return !(value > 0); });
  if (values.empty()) return "";
  const auto [least, largest] = std::ranges::minmax(values);
  const std::string set = std::string("set ") + axis + "tics ";
  if (!(largest < 100 * least)) return set + "autofreq\n";
  std::ostringstream text;
  for (const double number : numbers_along(least, largest, least_step))
    text << (text.str().empty() ? "" : ", ") << number;
  return set + "(" + text.str() + ")\n";
}

template <class Value>
std::vector<double> values_of(const Plot& plot, Value PlotPoint::*value) {
  std::vector<double> values;
  for (const auto& curve : plot.curves)
    for (const auto& point : curve.points)
      if (on_axes(point)) values.push_back(static_cast<double>(point.*value));
  return values;
}

// One panel: a column of the data against the first, and what is allowed of it.
std::string panel(const Plot& plot, int column, bool titles, std::optional<double> allowed = {}) {
  std::ostringstream text;
  text << "plot";
  int block = 0;
  for (const auto& curve : plot.curves) {
    if (!drawn(curve)) continue;
    text << (block > 0 ? ", \\\n     " : " ") << "data index " << block << " using 1:" << column
         << " with linespoints lt " << curve.colour << " pt 7 ps 0.45 "
         << (titles ? "title " + quoted(curve.name) : "notitle");
    ++block;
  }
  if (allowed) text << ", \\\n     " << *allowed << " with lines lt 7 dt 4 notitle";
  text << '\n';
  return text.str();
}

// That of all figures, docs/figures/common.gp.
constexpr const char* style =
    R"gp(set terminal svg size 760,560 font 'sans,13' background rgb 'white'
set border 3 lc rgb '#666666'
set tics nomirror textcolor rgb '#222222'
set grid lc rgb '#e4e4e4' lt 1
set key noenhanced reverse Left samplen 2
set linetype 1 lc rgb '#0060ad'
set linetype 2 lc rgb '#d95319'
set linetype 3 lc rgb '#4f9d2f'
set linetype 4 lc rgb '#7e2f8e'
set linetype 5 lc rgb '#a2842c'
set linetype 6 lc rgb '#008b8b'
set linetype 7 lc rgb '#888888'
)gp";

std::string script(const std::string& name, const Plot& plot) {
  std::vector<double> errors = values_of(plot, &PlotPoint::error);
  if (plot.allowed) errors.push_back(*plot.allowed);
  std::ostringstream text;
  text << "# gnuplot " << plain(name) << ".gp\n"
       << style << "set output " << quoted(name + ".svg") << "\ndata = " << quoted(name + ".dat")
       << "\nset multiplot title " << quoted(plot.title) << " noenhanced\n"
       << "set logscale xy\nset format xy '%g'\nset autoscale noextend\n"
       << "set offsets graph 0.05, graph 0.05, graph 0.1, graph 0.05\n"
       << "set lmargin at screen 0.12\nset rmargin at screen 0.97\n"
       << tics('x', values_of(plot, &PlotPoint::seconds))  //
       << "set tmargin at screen 0.92\nset bmargin at screen 0.50\nset format x ''\n"
       << "set ylabel " << quoted(plot.error_axis) << " noenhanced\n"
       << tics('y', errors) << "unset key\n";
  if (plot.allowed)
    text << "set label 1 'allowed' at graph 0.01, first " << *plot.allowed
         << " offset 0,0.5 tc lt 7\n";
  text << panel(plot, 2, false, plot.allowed) << "unset label\n"
       << "set tmargin at screen 0.46\nset bmargin at screen 0.22\nset format x '%g'\n"
       << "set xlabel 'seconds'\nset ylabel " << quoted(plot.count_axis) << " noenhanced\n"
       << tics('y', values_of(plot, &PlotPoint::count), 1)
       << "set key at screen 0.5, screen 0.02 center bottom horizontal\n"
       << panel(plot, 3, true) << "unset multiplot\n";
  return text.str();
}

std::string script(const std::string& name, const CountPlot& plot) {
  std::set<double> numbers;
  for (const CountCurve& curve : plot.curves)
    for (const auto& [x, count] : curve.points) numbers.insert(x);
  std::string tics;
  for (const double number : numbers) tics += (tics.empty() ? "" : ", ") + number_text(number);
  std::ostringstream text;
  text << "# gnuplot " << plain(name) << ".gp\n"
       << style << "set output " << quoted(name + ".svg") << "\ndata = " << quoted(name + ".dat")
       << "\nset title " << quoted(plot.title) << " noenhanced\nset logscale x\n"
       << "set format x '%g'\nset autoscale noextend\nset yrange [0:*]\n"
       << "set offsets graph 0.05, graph 0.05, graph 0.1, 0\n"
       << "set xlabel " << quoted(plot.x_axis) << " noenhanced\nset ylabel "
       << quoted(plot.count_axis) << " noenhanced\n"
       << "set xtics (" << tics << ")\nset key above\nplot";
  for (std::size_t block = 0; block < plot.curves.size(); ++block) {
    const CountCurve& curve = plot.curves[block];
    text << (block > 0 ? ", \\\n     " : " ") << "data index " << block
         << " using 1:2 with linespoints lt " << curve.colour << " dt " << curve.dashes
         << " pt 7 ps 0.6 title " << quoted(curve.name);
  }
  text << '\n';
  return text.str();
}

std::string data(const CountPlot& plot) {
  std::ostringstream text;
  text << "# " << plain(plot.x_axis) << ", " << plain(plot.count_axis)
       << "; two blank lines between curves\n"
       << std::setprecision(9);
  for (const CountCurve& curve : plot.curves) {
    text << (&curve == &plot.curves.front() ? "" : "\n\n") << "# " << plain(curve.name) << '\n';
    for (const auto& [x, count] : curve.points) text << x << ' ' << count << '\n';
  }
  return text.str();
}

}  // namespace

PlotCurve& curve_of(Plot& plot, const std::string& name) {
  const auto curve = std::ranges::find(plot.curves, name, &PlotCurve::name);
  if (curve != plot.curves.end()) return *curve;
  const int colour = static_cast<int>(plot.curves.size()) + 1;
  return plot.curves.emplace_back(PlotCurve{.name = name, .colour = colour});
}

bool has_points(const Plot& plot) { return std::ranges::any_of(plot.curves, drawn); }

std::vector<io::NamedText> plot_files(const std::string& name, const Plot& plot) {
  return {{name + ".dat", data(plot)}, {name + ".gp", script(name, plot)}};
}

std::vector<io::NamedText> count_files(const std::string& name, const CountPlot& plot) {
  return {{name + ".dat", data(plot)}, {name + ".gp", script(name, plot)}};
}

}  // namespace tencer::app::study
