#include "rests/files.hpp"

#include <string>
#include <tencer/io/design.hpp>
#include <tencer/io/export.hpp>

#include "drawing/picture.hpp"
#include "rests/words.hpp"
#include "view_page.hpp"

namespace tencer::app {
namespace {

// So many of the poses on the way at most, the first, the last and the pass among them.
std::vector<PagePose> thinned(const rehearsal::DesignPass& pass) {
  constexpr std::size_t most = 40;
  const std::size_t each = pass.way.size() / most + 1;
  std::vector<PagePose> poses;
  for (std::size_t k = 0; k < pass.way.size(); ++k)
    if (k % each == 0 || k + 1 == pass.way.size() || static_cast<int>(k) == pass.top)
      poses.push_back({label_of(pass, k), pass.way[k]});
  return poses;
}

// A design of each pass, with the poses on its way; the design alone where there are none.
std::string ways_page(const rehearsal::DesignRests& found) {
  if (found.passes.empty()) return view_page(found.rests[0].design);
  std::vector<model::Design> designs;
  for (const rehearsal::DesignPass& pass : found.passes) {
    designs.push_back(found.rests[static_cast<std::size_t>(pass.from)].design);
    designs.back().name =
        "rest " + std::to_string(pass.from + 1) + " to rest " + std::to_string(pass.to + 1);
  }
  std::vector<PageDesign> shown;
  for (std::size_t p = 0; p < designs.size(); ++p)
    shown.push_back({.design = designs[p], .poses = thinned(found.passes[p])});
  return view_page(shown);
}

}  // namespace

std::vector<io::NamedText> rests_files(const rehearsal::DesignRests& found) {
  std::vector<io::NamedText> files{{"rests.json", rests_json(found)},
                                   {"report.txt", in_words(found)},
                                   {"view.html", ways_page(found)}};
  for (std::size_t i = 0; i < found.rests.size(); ++i) {
    const model::Design& design = found.rests[i].design;
    const std::string name = "rest-" + std::to_string(i + 1);
    files.push_back({name + ".json", io::design_text(design)});
    files.push_back({name + ".obj", io::export_text(design, io::ExportFormat::obj)});
    files.push_back({name + ".svg", picture(design, PictureFormat::svg)});
  }
  return files;
}

}  // namespace tencer::app
