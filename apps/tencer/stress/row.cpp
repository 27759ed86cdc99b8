#include "row.hpp"

namespace tencer::app::stress {

Row stable(Row row) {
  row.stable = true;
  return row;
}

Judgement judge(const Row& row) {
  if (!row.ended) return {Verdict::failed, "did not end"};
  if (!row.finite) return {Verdict::failed, "returned a number that is not finite"};
  if (row.claims_stable && row.stable == false)
    return {Verdict::failed, "an unstable state called stable"};
  if (!row.claims_answer) {
    if (row.report.empty()) return {Verdict::failed, "no answer and no report"};
    return {Verdict::reported, row.report};
  }
  if (row.error && *row.error > row.promise) return {Verdict::failed, "wrong: " + row.report};
  return {Verdict::converged, row.report};
}

}  // namespace tencer::app::stress
