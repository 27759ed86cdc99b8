#include <catch2/catch.hpp>
#include <limits>
#include <tencer/io/trace.hpp>
#include <vector>

#include "fixtures/folder.hpp"

using tencer::io::write_trace;
using tencer::model::StageRow;

TEST_CASE("the trace is a CSV table with quoted texts") {
  const Folder folder;
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<StageRow> rows{
      {"prune", 0.1, 87, 0.024, 1e-3, 12, 140, ""},
      {"greedy", 2, 51, 0.1 + 0.2, 0, 36, 200, "stopped, \"weakest\" kept\nsecond line"},
      {"targets", 0, 0, none, none, 0, 0, "one rod"}};
  REQUIRE_FALSE(write_trace(folder / "trace.csv", rows));
  CHECK(folder.text("trace.csv") ==
        "stage,seconds,cables,max_percent,rms_percent,equilibrium_solves,newton_iterations,note\n"
        "prune,0.1,87,0.024,0.001,12,140,\n"
        "greedy,2,51,0.30000000000000004,0,36,200,\"stopped, \"\"weakest\"\" kept\nsecond line\"\n"
        "targets,0,0,,,0,0,one rod\n");
  CHECK(write_trace(folder / "none/trace.csv", rows));
}
