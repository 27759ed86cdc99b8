// Data and scripts for gnuplot: error against run time, both axes logarithmic, and below it how
// many there are of something against the same time; or the latter alone, against anything.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <tencer/io/file.hpp>
#include <utility>
#include <vector>

namespace tencer::app::study {

struct PlotPoint {
  double seconds = 0.0;
  double error = 0.0;  // not positive: not known
  int count = 0;       // of cables, or edges; 0: none, or not known
};

// Points joined by a line in the given order. Colours are numbered from 1.
struct PlotCurve {
  std::string name{};
  int colour = 1;
  std::vector<PlotPoint> points{};
};

struct Plot {
  std::string title{};
  std::string error_axis{};
  std::string count_axis{};         // "cables"
  std::optional<double> allowed{};  // an error, drawn as a line
  std::vector<PlotCurve> curves{};
};

// NAME.dat, one block a curve, and NAME.gp, which draws NAME.svg from it: `gnuplot NAME.gp` in
// their folder. What is not positive has no place on the axes and is left out, and so are curves
// without points.
std::vector<io::NamedText> plot_files(const std::string& name, const Plot& plot);

// The plot's curve of this name, which is made, with the next colour, where it is not there.
PlotCurve& curve_of(Plot& plot, const std::string& name);

// Whether there is anything to be drawn.
bool has_points(const Plot& plot);

struct CountCurve {
  std::string name{};
  int colour = 1;
  int dashes = 1;                                   // 1: none
  std::vector<std::pair<double, double>> points{};  // joined in this order
};

// Counts against a positive number on a logarithmic axis.
struct CountPlot {
  std::string title{};
  std::string x_axis{};
  std::string count_axis{};
  std::vector<CountCurve> curves{};
};

// Likewise.
std::vector<io::NamedText> count_files(const std::string& name, const CountPlot& plot);

}  // namespace tencer::app::study
