// The table of a study, study.csv: one line a run. A run's record is such a table of its own.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tencer/core/error.hpp>
#include <tencer/io/design.hpp>
#include <utility>
#include <vector>

namespace tencer::app::study {

// The shortest text that reads back as the same number: 0.5, 1, 2.
std::string number_text(double number);

// One design to be made.
struct Run {
  std::string scene;  // its file's name without extension: the name of its picture
  std::string file;   // as given on the command line
  std::string method;
  std::string optimizer;
  double resolution = 1.0;
  std::optional<double> max_error{};  // %; none: the scene's
};

// "trefoil, force-balance, gauss-newton, x0.5, max error 2 %"; also the name of the run's folder,
// with dashes.
std::string title_of(const Run& run);
std::string folder_of(const Run& run);

struct Row {
  Run run{};
  std::string status{};  // that of the design (io::status_name), or "failed"
  std::optional<int> vertices{};
  std::optional<int> cables{};
  std::optional<int> external_cables{};
  std::optional<double> max_percent{};
  std::optional<double> rms_percent{};
  double seconds = 0.0;                                  // of the whole run
  std::vector<std::pair<std::string, double>> stages{};  // seconds of each, in order
  std::optional<bool> stands{};
  std::optional<bool> settles{};
  std::optional<double> smallest_eigenvalue{};  // the margin of stability, in max EI / L^4
  std::string machine{};                        // that made it, by its name in the network
  std::string message{};                        // when something is not as asked
};

// What a finished design says of itself.
Row row_of(const Run& run, const model::Design& design, double seconds);

// A header and a line a row. Stages have a column each, seconds_NAME, empty where a run has none.
std::string table_text(std::span<const Row> rows);

// The rows of such a text, whichever stages it has; `path` is named in errors.
core::Expected<std::vector<Row>> parse_table(const std::filesystem::path& path,
                                             std::string_view text);

// Whether two runs are one and the same, done twice.
bool same_run(const Run& a, const Run& b);

}  // namespace tencer::app::study
