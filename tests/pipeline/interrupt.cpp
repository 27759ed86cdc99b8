// A stop request leaves the best design so far: a sound file that says it was interrupted.
#include <stop_token>

#include "scenes.hpp"

using namespace tencer;

namespace {

void check_interrupted(const model::Design& design) {
  CHECK(design.status == model::DesignStatus::interrupted);
  REQUIRE(design.certificate);
  CHECK_FALSE(design.certificate->settles_from_target);  // not tried
  CHECK_FALSE(design.structure.cables.empty());
  const auto problem = io::design_problem("design.json", design);
  CHECK((problem ? problem->text() : "") == "");
}

}  // namespace

TEST_CASE("a stop before the start") {
  std::stop_source stop;
  stop.request_stop();
  const model::Design design = designed(trefoil_scene(), {.stop = stop.get_token()});
  check_interrupted(design);
  // What balances the forces at the target is not there yet.
  CHECK(design.certificate->residual < 1e-5);
  CHECK(design.error->max_percent > 1e-6);
}

TEST_CASE("a stop in each stage") {
  using model::Method;
  struct Case {
    Method method;
    std::string stage;
    std::string last{};  // that ran; the same when empty
  };
  for (const Case& stopped :
       {Case{Method::force_balance, "eliminate", "fit"}, Case{Method::dense_springs, "prune"},
        Case{Method::dense_springs, "greedy"}, Case{Method::dense_springs, "sparsify"},
        Case{Method::dense_springs, "slide"}, Case{Method::dense_springs, "eliminate"}}) {
    CAPTURE(model::name_of(stopped.method), stopped.stage);
    std::stop_source stop;
    model::Scene scene = trefoil_scene();
    scene.design.method = stopped.method;
    const model::Design design =
        designed(scene, {.stop = stop.get_token(), .progress = [&](const network::Progress& at) {
                           if (at.stage == stopped.stage) stop.request_stop();
                         }});
    check_interrupted(design);
    REQUIRE_FALSE(design.trace.empty());
    CHECK(design.trace.back().stage == (stopped.last.empty() ? stopped.stage : stopped.last));
    check_consistent(design);
  }
}
