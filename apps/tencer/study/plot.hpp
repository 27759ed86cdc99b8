// Data and scripts for gnuplot: error against run time, both axes logarithmic.
#pragma once

#include <span>
#include <string>
#include <tencer/io/file.hpp>
#include <vector>

namespace tencer::app::study {

struct PlotPoint {
  double seconds = 0.0;
  double error = 0.0;
  std::string label{};  // beside the point; may be empty
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
  std::string label_note{};  // what the labels are; may be empty
  std::vector<PlotCurve> curves{};
};

// NAME.dat, one block a curve, and NAME.gp, which draws NAME.svg from it: `gnuplot NAME.gp` in
// their folder. Points without a positive error or time have no place on the axes and are left out,
// and so are curves without points.
std::vector<io::NamedText> plot_files(const std::string& name, const Plot& plot);

// Whether there is anything to be drawn.
bool has_points(const Plot& plot);

}  // namespace tencer::app::study
