#include <tencer/core/words.hpp>
#include <tencer/io/schedule.hpp>

#include "scene/toml_value.hpp"
#include "text/bad_input.hpp"
#include "text/read_text.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

constexpr std::string_view frames_key = "frames";
constexpr std::string_view all_key = "all";

struct CableRange {
  int first = 0;
  int last = 0;
};

// Of the cables that a key names, "3" or "2-5" or "all", from 1.
CableRange cables_of(const TomlTable& step, const std::string& key, int count) {
  if (key == all_key) return {1, count};
  const auto dash = key.find('-');
  const auto first = to_integer(key.substr(0, dash));
  const auto last = dash == std::string::npos ? first : to_integer(key.substr(dash + 1));
  if (!first || !last)
    step.fail(key,
              "is no cable; keys are numbers of cables (3), ranges of them (2-5), all and "
              "frames");
  if (*first < 1 || *last > count || *first > *last)
    step.fail(key, "the design has no such cable: it has " + core::counted(count, "cable") +
                       (count > 0 ? ", from 1" : ""));
  return {static_cast<int>(*first), static_cast<int>(*last)};
}

model::LengthChange read_change(const TomlTable& step, const std::string& key) {
  const std::string text = step.need(key, step.text(key));
  const auto change = model::read_length_change(text);
  if (!change)
    step.fail(key, "expected \"by -12 mm\", \"by -10 %\", \"to 80 mm\" or \"to 100 %\", found " +
                       ('"' + text + '"'));
  return *change;
}

model::ScheduleStep read_step(const TomlTable& step, int cables) {
  model::ScheduleStep result;
  result.changes.resize(static_cast<std::size_t>(cables));
  result.frames = step.integer(frames_key, 1, 10000).value_or(result.frames);
  for (const std::string& key : step.keys()) {
    if (key == frames_key) continue;
    const CableRange range = cables_of(step, key, cables);
    const model::LengthChange change = read_change(step, key);
    for (int cable = range.first; cable <= range.last; ++cable) {
      auto& entry = result.changes[static_cast<std::size_t>(cable - 1)];
      if (entry) step.fail(key, "cable " + std::to_string(cable) + " is named twice in this step");
      entry = change;
    }
  }
  return result;
}

// A length after this step that is none.
void check_lengths(const TomlTable& step, const Eigen::VectorXd& lengths) {
  for (Eigen::Index c = 0; c < lengths.size(); ++c)
    if (!(lengths[c] > 0))
      fail(step.where(), "after this step cable " + std::to_string(c + 1) + " has the length " +
                             to_text(lengths[c]) + "; it must stay above zero");
}

// Of a file, or with an empty name of what is in none.
model::Schedule parse_schedule(const std::string& text, const std::string& file,
                               const model::Design& design) {
  const toml::table content = TomlTable::parse(text, file);
  const TomlTable root(content);
  root.only({"step"});
  const std::vector<TomlTable> steps = root.tables("step");
  if (steps.empty()) fail(file, "has no step; write [[step]] and below it 1 = \"by -10 %\"");
  model::Schedule schedule;
  for (const TomlTable& step : steps)
    schedule.steps.push_back(read_step(step, static_cast<int>(design.built.size())));
  const auto lengths = model::lengths_of(schedule, design);
  for (std::size_t k = 0; k < steps.size(); ++k) check_lengths(steps[k], lengths[k]);
  return schedule;
}

}  // namespace

core::Expected<model::Schedule> read_schedule(const std::filesystem::path& path,
                                              const model::Design& design) {
  return guarded([&] { return parse_schedule(read_text(path), shown(path), design); });
}

core::Expected<model::Schedule> schedule_of_text(const std::string& text,
                                                 const model::Design& design) {
  return guarded([&] { return parse_schedule(text, "", design); });
}

}  // namespace tencer::io
