#include "design_files.hpp"

#include <iomanip>
#include <sstream>
#include <tencer/io/curve.hpp>
#include <tencer/io/file.hpp>
#include <tencer/io/trace.hpp>
#include <vector>

#include "picture.hpp"
#include "view_page.hpp"

namespace tencer::app {

std::optional<core::Error> write_design_files(const std::filesystem::path& folder,
                                              const io::Design& design) {
  if (auto error = io::design_problem(folder / "design.json", design)) return error;
  std::vector<geometry::Polyline> poses;
  for (const auto& rod : design.rods) poses.push_back({rod.pose, rod.closed});
  const std::vector<io::NamedText> files{{"design.json", io::design_text(design)},
                                         {"trace.csv", io::trace_text(design.trace)},
                                         {"pose.obj", io::obj_text(poses)},
                                         {"view.html", view_page(design)},
                                         {"picture.svg", picture_svg(design)}};
  return io::write_files(folder, files);
}

std::string summary(const io::Design& design) {
  std::ostringstream text;
  int external = 0;
  for (const auto& cable : design.cables)
    if (cable.a.anchor >= 0 || cable.b.anchor >= 0) ++external;
  text << design.cables.size() << " cables";
  if (design.anchors.cols() > 0)
    text << " (" << static_cast<int>(design.cables.size()) - external << " internal, " << external
         << " external)";
  text << std::setprecision(3);
  if (design.error)
    text << ", max error " << design.error->max_percent << " %, rms " << design.error->rms_percent
         << " % of the target's size";
  text << '\n';
  if (design.certificate) {
    const io::Certificate& certificate = *design.certificate;
    text << (certificate.stable ? "stands" : "does not stand")
         << " with inextensible cables: force imbalance " << certificate.residual
         << ", smallest eigenvalue " << certificate.smallest_eigenvalue << " ("
         << certificate.eigenvalue_unit << "), " << certificate.slack_cables << " slack cables\n";
    if (certificate.settles_from_target)
      text << (*certificate.settles_from_target
                   ? "let go at the target it comes to rest in this pose\n"
                   : "let go at the target it comes to rest elsewhere\n");
  }
  return text.str();
}

}  // namespace tencer::app
