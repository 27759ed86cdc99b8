// Data and scripts for gnuplot: error against run time, both axes logarithmic, and below it how
// many there are of something against the same time.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <tencer/io/file.hpp>
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

// Whether there is anything to be drawn.
bool has_points(const Plot& plot);

}  // namespace tencer::app::study
