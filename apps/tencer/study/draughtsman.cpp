#include "draughtsman.hpp"

#include <algorithm>
#include <tencer/io/file.hpp>

#include "child.hpp"

namespace tencer::app::study {
namespace {

bool holds(const std::filesystem::path& path, const std::string& text) {
  if (!std::filesystem::exists(path)) return false;
  const auto found = io::read_file(path);
  return found && *found == text;
}

}  // namespace

std::filesystem::path gnuplot_log(const std::filesystem::path& folder) {
  return folder / "gnuplot.log";
}

std::optional<core::Error> Draughtsman::draw(const std::string& name,
                                             const std::vector<io::NamedText>& files) {
  const std::filesystem::path picture = folder_ / (name + ".svg");
  if (std::filesystem::exists(picture) &&
      std::ranges::all_of(
          files, [&](const io::NamedText& file) { return holds(folder_ / file.name, file.text); }))
    return std::nullopt;
  std::filesystem::remove(picture);  // none is there of other data
  if (auto error = io::write_files(folder_, files)) return error;
  if (missing_) return std::nullopt;
  const auto end =
      run_child("gnuplot", {name + ".gp"}, {.folder = folder_, .log = gnuplot_log(folder_)});
  missing_ = !end.found;
  if (missing_) {
    log_(core::Level::warning,
         "there is no gnuplot (in Debian the package gnuplot-nox), so no pictures are drawn; with "
         "it, `gnuplot " +
             name + ".gp` in " + folder_.string() + " draws this one");
  } else if (end.exit_code != 0) {
    std::filesystem::remove(picture);
    log_(core::Level::warning,
         "gnuplot could not draw " + name + ".gp; see " + gnuplot_log(folder_).string());
  }
  return std::nullopt;
}

}  // namespace tencer::app::study
