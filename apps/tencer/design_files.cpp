#include "design_files.hpp"

#include <algorithm>
#include <array>
#include <iomanip>
#include <set>
#include <sstream>
#include <system_error>
#include <tencer/io/csv.hpp>
#include <tencer/io/curve.hpp>
#include <tencer/io/feasibility.hpp>
#include <tencer/io/file.hpp>
#include <tencer/io/trace.hpp>
#include <tencer/model/target.hpp>
#include <tencer/model/units.hpp>
#include <utility>
#include <vector>

#include "drawing/motion_picture.hpp"
#include "drawing/picture.hpp"
#include "view_page.hpp"

namespace tencer::app {
namespace {

namespace fs = std::filesystem;

std::vector<io::NamedText> files_of(const model::Design& design, std::string page) {
  std::vector<geometry::Polyline> poses;
  for (std::size_t r = 0; r < design.pose.size(); ++r)
    poses.push_back(model::pose_curve(design, r));
  return {{"design.json", io::design_text(design)},
          {"trace.csv", io::trace_text(design.trace)},
          {"pose.obj", io::obj_text(poses)},
          {"report.txt", model::findings(design)},
          {"view.html", std::move(page)},
          {"picture.svg", picture(design, PictureFormat::svg)}};
}

// All designs on one page, which opens with the one asked for.
std::string trade_off_page(std::span<const model::Design> designs, const model::Design& asked) {
  std::vector<PageDesign> shown;
  std::size_t first = 0;
  for (const auto& design : designs) {
    if (design.structure.cables.size() == asked.structure.cables.size()) first = shown.size();
    shown.push_back({.design = design});
  }
  return view_page(shown, first);
}

std::string trade_off_csv(std::span<const model::Design> designs) {
  const auto yes = [](bool holds) { return std::string(holds ? "true" : "false"); };
  std::string text = "cables,max_percent,rms_percent,smallest_eigenvalue,stands,settles\n";
  for (const auto& design : designs) {
    const model::Certificate& certificate = *design.certificate;
    text += io::csv_line(std::array{
        std::to_string(design.structure.cables.size()), io::to_text(design.error->max_percent),
        io::to_text(design.error->rms_percent), io::to_text(certificate.smallest_eigenvalue),
        yes(certificate.stable), yes(*certificate.settles_from_target)});
  }
  return text;
}

std::string folder_name(const model::Design& design) {
  return "cables-" + std::to_string(design.structure.cables.size());
}

bool is_folder_name(const std::string& name) {
  constexpr std::string_view start = "cables-";
  return name.starts_with(start) && name.size() > start.size() &&
         name.find_first_not_of("0123456789", start.size()) == std::string::npos;
}

// All files that a result may have in its folder, and in those of its numbers of cables.
constexpr std::array result_files{"design.json", "trace.csv",   "pose.obj",      "report.txt",
                                  "view.html",   "picture.svg", "trade-off.csv", "feasible.json"};

std::optional<core::Error> remove_file(const fs::path& path) {
  std::error_code failed;
  if (!fs::is_regular_file(fs::symlink_status(path, failed)) || fs::remove(path, failed))
    return std::nullopt;
  return core::Error{
      path.string(),
      "is of the result that was here before, and cannot be removed: " + failed.message()};
}

// Removes what an earlier result has left in a folder that now has `written` files and `folders`.
std::optional<core::Error> remove_stale(const fs::path& folder,
                                        std::span<const io::NamedText> files,
                                        const std::set<std::string>& folders = {}) {
  for (const char* name : result_files)
    if (std::ranges::find(files, name, &io::NamedText::name) == files.end())
      if (auto error = remove_file(folder / name)) return error;
  std::error_code failed;
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(folder, failed)) {
    const std::string name = entry.path().filename().string();
    if (is_folder_name(name) && !folders.contains(name) && entry.is_directory(failed))
      old.push_back(entry.path());
  }
  for (const fs::path& one : old) {
    if (auto error = remove_stale(one, {})) return error;
    fs::remove(one, failed);  // when nothing else is in it
  }
  return std::nullopt;
}

// Folders that are not there yet: those of them that are made meanwhile are removed again, with the
// files of designs in them, unless they are kept.
class NewFolders {
 public:
  NewFolders() = default;
  NewFolders(const NewFolders&) = delete;
  NewFolders& operator=(const NewFolders&) = delete;
  ~NewFolders() {
    std::error_code ignored;
    for (const auto& folder : designs_) fs::remove_all(folder, ignored);
    for (auto above = above_.rbegin(); above != above_.rend(); ++above)
      fs::remove(*above, ignored);  // when it is empty
  }

  void add_above(const fs::path& folder) {
    std::error_code ignored;
    fs::path part;
    for (const fs::path& name : folder) {
      part /= name;
      if (!fs::exists(part, ignored)) above_.push_back(part);
    }
  }
  void add_design(const fs::path& folder) {
    std::error_code ignored;
    if (!fs::exists(folder, ignored)) designs_.push_back(folder);
  }
  void keep() {
    above_.clear();
    designs_.clear();
  }

 private:
  std::vector<fs::path> above_;
  std::vector<fs::path> designs_;
};

}  // namespace

bool holds_design(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder / "design.json", ignored);
}

std::optional<core::Error> result_problem(const fs::path& folder, const std::string& name,
                                          bool force) {
  if (auto error = io::folder_problem(folder)) return error;
  if (force || !holds_design(folder)) return std::nullopt;
  const std::string remedy = "; name another folder with -o, or replace it with --force";
  const auto there = io::read_design(folder / "design.json");
  if (!there)
    return core::Error{(folder / "design.json").string(),
                       "is there and is no design that can be read" + remedy};
  if (there->name == name) return std::nullopt;
  return core::Error{folder.string(),
                     "holds the design of '" + there->name + "', not of '" + name + "'" + remedy};
}

std::optional<core::Error> write_design_files(const std::filesystem::path& folder,
                                              const model::Design& design) {
  if (auto error = io::design_problem(folder / "design.json", design)) return error;
  const auto files = files_of(design, view_page(design));
  if (auto error = io::write_files(folder, files)) return error;
  return remove_stale(folder, files);
}

std::optional<std::string> old_sheet(const fs::path& folder) {
  std::error_code ignored;
  const fs::path sheet = folder / "sheet" / "sheet.pdf";
  if (!fs::exists(sheet, ignored)) return std::nullopt;
  return sheet.string() + " is of an earlier run: make it anew with tencer fabricate " +
         (folder / "design.json").string();
}

std::optional<core::Error> write_pictures(std::span<const std::filesystem::path> pictures,
                                          const model::Design& design) {
  for (const auto& path : pictures)
    if (auto error = io::write_file(path, picture(design, *picture_format(path)))) return error;
  return std::nullopt;
}

std::optional<core::Error> write_trade_off(const std::filesystem::path& folder,
                                           std::span<const model::Design> designs,
                                           const model::Design& asked) {
  const auto folder_of = [&](const model::Design& design) { return folder / folder_name(design); };
  std::set<std::string> folders;
  NewFolders made;
  made.add_above(folder.parent_path());
  made.add_design(folder);
  for (const auto& design : designs) {
    if (auto error = io::folder_problem(folder_of(design))) return error;
    made.add_design(folder_of(design));
    folders.insert(folder_name(design));
  }
  for (const auto& design : designs)
    if (auto error = write_design_files(folder_of(design), design)) return error;
  std::vector<io::NamedText> files = files_of(asked, trade_off_page(designs, asked));
  files.push_back({"trade-off.csv", trade_off_csv(designs)});
  if (auto error = io::write_files(folder, files)) return error;
  made.keep();
  return remove_stale(folder, files, folders);
}

std::optional<core::Error> write_feasibility_files(const std::filesystem::path& folder,
                                                   const model::Feasibility& feasibility) {
  return io::write_files(
      folder, std::vector<io::NamedText>{{"feasible.json", io::feasibility_text(feasibility)},
                                         {"picture.svg", motion_picture(feasibility)}});
}

std::string trade_off_table(std::span<const model::Design> designs) {
  if (designs.empty()) return "";
  std::ostringstream text;
  text << std::setprecision(3) << "cables  max mm    max %     rms %     stands  settles\n";
  for (const auto& design : designs) {
    const model::Certificate& certificate = *design.certificate;
    const double diagonal = model::diagonal({.points = design.target});
    const double mm = 1000 * model::metres(design.length_unit) * diagonal / 100;
    text << std::left << std::setw(8) << design.structure.cables.size() << std::setw(10)
         << design.error->max_percent * mm << std::setw(10) << design.error->max_percent
         << std::setw(10) << design.error->rms_percent << std::setw(8)
         << (certificate.stable ? "yes" : "no") << (*certificate.settles_from_target ? "yes" : "no")
         << '\n';
  }
  return text.str();
}

}  // namespace tencer::app
