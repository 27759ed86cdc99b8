// A stop request leaves the best design so far: a sound file that says it was interrupted.
#include <stop_token>

#include "scenes.hpp"

using namespace tencer;

namespace {

void check_interrupted(const io::Design& design) {
  CHECK(design.status == io::DesignStatus::interrupted);
  REQUIRE(design.certificate);
  CHECK_FALSE(design.certificate->settles_from_target);  // not tried
  CHECK_FALSE(design.cables.empty());
  const auto problem = io::design_problem("design.json", design);
  CHECK((problem ? problem->text() : "") == "");
}

}  // namespace

TEST_CASE("a stop before the start") {
  std::stop_source stop;
  stop.request_stop();
  check_interrupted(designed(trefoil_scene(), {.stop = stop.get_token()}));
}

TEST_CASE("a stop in each stage") {
  struct Case {
    std::string method;
    std::string stage;
  };
  for (const Case& stopped : {Case{"force-balance", "thin"}, Case{"dense-springs", "prune"},
                              Case{"dense-springs", "greedy"}, Case{"dense-springs", "sparsify"},
                              Case{"dense-springs", "slide"}, Case{"dense-springs", "thin"}}) {
    CAPTURE(stopped.method, stopped.stage);
    std::stop_source stop;
    io::Scene scene = trefoil_scene();
    scene.design.method = stopped.method;
    const io::Design design =
        designed(scene, {.stop = stop.get_token(), .progress = [&](const sparsify::Progress& at) {
                           if (at.stage == stopped.stage) stop.request_stop();
                         }});
    check_interrupted(design);
    REQUIRE_FALSE(design.trace.empty());
    CHECK(design.trace.back().stage == stopped.stage);
    check_consistent(design);
  }
}
