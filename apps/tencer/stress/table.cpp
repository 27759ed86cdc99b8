#include "table.hpp"

#include <array>
#include <cstdio>
#include <iomanip>
#include <string>

#include "groups.hpp"

namespace tencer::app::stress {
namespace {

std::string scientific(const std::optional<double>& value) {
  if (!value) return "-";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.0e", *value);
  return text.data();
}

std::string word(Verdict verdict) {
  switch (verdict) {
    case Verdict::converged:
      return "converged";
    case Verdict::reported:
      return "reported";
    case Verdict::failed:
      return "FAILED";
  }
  return {};
}

void print_text(std::ostream& out, const Group& group) {
  out << '\n' << group.title << "\n\n";
  for (const Row& row : group.rows) {
    const Judgement judgement = judge(row);
    out << "  " << std::left << std::setw(50) << row.name << ' ' << std::setw(9)
        << word(judgement.verdict) << std::right << std::setw(5)
        << (row.iterations ? std::to_string(*row.iterations) : "-") << std::setw(7)
        << scientific(row.residual) << std::setw(7) << scientific(row.error) << std::setw(7)
        << scientific(row.promise) << "  " << judgement.why << '\n';
  }
}

void print_markdown(std::ostream& out, const Group& group) {
  out << "\n### " << group.title
      << "\n\n| case | verdict | iterations | residual | error | promised | known answer | report "
         "|\n|---|---|---|---|---|---|---|---|\n";
  for (const Row& row : group.rows) {
    const Judgement judgement = judge(row);
    out << "| " << row.name << " | " << word(judgement.verdict) << " | "
        << (row.iterations ? std::to_string(*row.iterations) : "-") << " | "
        << scientific(row.residual) << " | " << scientific(row.error) << " | "
        << scientific(row.promise) << " | " << row.known << " | " << judgement.why << " |\n";
  }
}

}  // namespace

int print_table(std::ostream& out, Format format) {
  int failed = 0;
  if (format == Format::text)
    out << "  " << std::left << std::setw(50) << "case"
        << " verdict    iter  resid  error promise\n";
  for (const MakeGroup make : groups) {
    const Group group = make();
    format == Format::text ? print_text(out, group) : print_markdown(out, group);
    out << std::flush;
    for (const Row& row : group.rows)
      if (judge(row).verdict == Verdict::failed) ++failed;
  }
  return failed;
}

}  // namespace tencer::app::stress
