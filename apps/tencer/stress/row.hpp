// One line of the stress table and how it is judged.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tencer::app::stress {

struct Row {
  std::string name{};
  std::string known{};            // what the answer is compared with
  double promise = 0.0;           // largest error that passes
  std::optional<double> error{};  // none: nothing to compare with
  std::optional<int> iterations{};
  std::optional<double> residual{};
  bool claims_answer = false;    // the library says: this is the answer asked for
  bool claims_stable = false;    // it says: stable
  std::optional<bool> stable{};  // what is known of that, where it is
  bool ended = true;             // by itself, before the deadline
  bool finite = true;            // every number returned
  std::string report{};          // the library's words
};

// The row, of something that is known to be stable.
Row stable(Row row);

enum class Verdict {
  converged,  // an answer within the promise
  reported,   // no answer claimed; the report names the trouble
  failed      // anything else
};

struct Judgement {
  Verdict verdict = Verdict::failed;
  std::string why{};
};

Judgement judge(const Row& row);

struct Group {
  std::string title{};
  std::vector<Row> rows{};
};

}  // namespace tencer::app::stress
