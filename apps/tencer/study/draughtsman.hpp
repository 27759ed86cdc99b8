// Has gnuplot draw the plots of a study.
#pragma once

#include <filesystem>
#include <optional>
#include <tencer/core/error.hpp>
#include <tencer/core/log.hpp>
#include <tencer/io/file.hpp>
#include <vector>

namespace tencer::app::study {

// One at a time works in a folder: it holds the log of gnuplot there.
std::filesystem::path gnuplot_log(const std::filesystem::path& folder);

// Writes the plot's files in the folder, NAME.dat and NAME.gp, and has gnuplot draw NAME.svg,
// unless it is there and drawn from the same. Where there is no gnuplot, or it fails, the log is
// told.
class Draughtsman {
 public:
  Draughtsman(const std::filesystem::path& folder, const core::Log& log)
      : folder_(folder), log_(log) {}

  std::optional<core::Error> draw(const std::string& name, const std::vector<io::NamedText>& files);

 private:
  std::filesystem::path folder_;
  const core::Log& log_;
  bool missing_ = false;
};

}  // namespace tencer::app::study
