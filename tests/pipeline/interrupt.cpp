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
  for (const std::string stage : {"prune", "greedy", "sparsify", "slide"}) {
    CAPTURE(stage);
    std::stop_source stop;
    const io::Design design = designed(
        trefoil_scene(), {.stop = stop.get_token(), .progress = [&](const sparsify::Progress& at) {
                            if (at.stage == stage) stop.request_stop();
                          }});
    check_interrupted(design);
    REQUIRE_FALSE(design.trace.empty());
    CHECK(design.trace.back().stage == stage);
    check_consistent(design);
  }
}
