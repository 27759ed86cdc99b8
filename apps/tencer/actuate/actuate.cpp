#include "actuate/actuate.hpp"

#include <algorithm>
#include <tencer/io/export.hpp>

#include "actuate/words.hpp"
#include "drawing/picture.hpp"
#include "view_page.hpp"

namespace tencer::app {
namespace {

// "pose-0012.obj"
std::string pose_name(std::size_t k) {
  const std::string number = std::to_string(k);
  constexpr std::size_t digits = 4;
  return "pose-" + std::string(digits - std::min(digits, number.size()), '0') + number + ".obj";
}

}  // namespace

std::string view_page(const rehearsal::Actuated& actuated) {
  PageDesign shown{.design = actuated.design};
  for (const rehearsal::ActuatedPose& pose : actuated.poses)
    shown.poses.push_back({label_of(pose), pose.pose});
  return view_page(std::span(&shown, 1));
}

std::vector<io::NamedText> actuation_files(const rehearsal::Actuated& actuated) {
  const auto at = [&](const rehearsal::ActuatedPose& pose) {
    return rehearsal::in_pose(actuated.design, pose);
  };
  std::vector<io::NamedText> files{
      {"poses.csv", poses_csv(actuated)},
      {"report.txt", in_words(actuated)},
      {"view.html", view_page(actuated)},
      {"start.svg", picture(at(actuated.poses.front()), PictureFormat::svg)},
      {"end.svg", picture(at(actuated.poses.back()), PictureFormat::svg)}};
  for (std::size_t k = 0; k < actuated.poses.size(); ++k)
    files.push_back({pose_name(k), io::export_text(at(actuated.poses[k]), io::ExportFormat::obj)});
  return files;
}

}  // namespace tencer::app
