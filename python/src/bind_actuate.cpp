// A design whose cables are pulled and let go: the poses that it goes through, as arrays.
#include <limits>
#include <tencer/io/schedule.hpp>
#include <tencer/rehearsal/actuate.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "long_call.hpp"
#include "parts.hpp"

namespace tencer::python {
namespace {

using rehearsal::Actuated;
using rehearsal::ActuatedPose;

Actuated actuate(const model::Design& design, const std::optional<std::filesystem::path>& file,
                 const std::string& text) {
  const model::Schedule schedule =
      value_or_raise(file ? io::read_schedule(*file, design) : io::schedule_of_text(text, design));
  return value_or_raise(long_call(py::none(), [&](LongCall& call) {
    return rehearsal::actuate(design, schedule, call.token());
  }));
}

// A number of every pose, (poses).
template <class Number>
auto of_poses(Number number) {
  return [number](const Actuated& self) {
    std::vector<decltype(number(self.poses.front()))> numbers;
    for (const ActuatedPose& pose : self.poses) numbers.push_back(number(pose));
    return table(numbers);
  };
}

// A number of every cable in every pose, (poses, cables).
auto of_cables(double model::BuiltCable::*number) {
  return [number](const Actuated& self) {
    const auto poses = static_cast<py::ssize_t>(self.poses.size());
    const auto cables = static_cast<py::ssize_t>(self.design.built.size());
    py::array_t<double> array({poses, cables});
    double* next = array.mutable_data();
    for (const ActuatedPose& pose : self.poses)
      for (const model::BuiltCable& cable : pose.built) *next++ = cable.*number;
    return array;
  };
}

double strands_apart(const ActuatedPose& pose) {
  return pose.closest.rods ? pose.closest.rods->distance : std::numeric_limits<double>::infinity();
}

const char* cause_name(motion::Cause cause) {
  switch (cause) {
    case motion::Cause::turning:
      return "turning";
    case motion::Cause::branching:
      return "branching";
    case motion::Cause::lost:
      break;
  }
  return "lost";
}

py::list jumps(const Actuated& self) {
  using namespace py::literals;
  py::list rows;
  for (const motion::Jump& jump : self.jumps)
    rows.append(py::dict("kind"_a = jump.smooth ? "buckles" : "snaps", "before"_a = jump.before,
                         "after"_a = jump.after, "cause"_a = cause_name(jump.cause),
                         "released"_a = jump.released, "moved"_a = jump.moved,
                         "strands_met"_a = jump.strands_met));
  return rows;
}

model::Design design_at(const Actuated& self, py::ssize_t pose) {
  const auto count = static_cast<py::ssize_t>(self.poses.size());
  if (pose < -count || pose >= count)
    throw py::index_error("pose: there are " + std::to_string(count) + ", found " +
                          std::to_string(pose));
  return rehearsal::in_pose(self.design,
                            self.poses[static_cast<std::size_t>(pose < 0 ? pose + count : pose)]);
}

}  // namespace

void bind_actuate(py::module_& module) {
  py::class_<Actuated>(module, "Actuation",
                       "What a design does while its cables are pulled and let go: the poses that "
                       "it goes through, the first being the start, and where it jumps.")
      .def_property_readonly("name", [](const Actuated& self) { return self.design.name; })
      .def_readonly("finished", &Actuated::finished,
                    "False when it was stopped, or no rest was found beyond the last pose.")
      .def("__len__", [](const Actuated& self) { return self.poses.size(); })
      .def_property_readonly(
          "poses",
          [](py::object self) {
            std::vector<std::vector<py::array>> all;
            for (const ActuatedPose& pose : self.cast<Actuated&>().poses)
              all.push_back(views(pose.pose, self));
            return all;
          },
          "Per pose and rod a view (n, 3), lengths.")
      .def_property_readonly("steps", of_poses([](const ActuatedPose& pose) { return pose.step; }),
                             "The step of the schedule that each pose is in, (poses,), from 0.")
      .def_property_readonly("parts", of_poses([](const ActuatedPose& pose) { return pose.part; }),
                             "How far it is in that step, (poses,), 0 to 1.")
      .def_property_readonly("energies",
                             of_poses([](const ActuatedPose& pose) { return pose.energy; }),
                             "Of rods and loads, (poses,), force times length.")
      .def_property_readonly(
          "strands_apart", of_poses(strands_apart),
          "How near strands of rods come, (poses,), lengths: below 0 where they overlap, inf where "
          "no two can meet.")
      .def_property_readonly("lengths", of_cables(&model::BuiltCable::length),
                             "Of cables, (poses, cables).")
      .def_property_readonly("tensions", of_cables(&model::BuiltCable::tension),
                             "What cables pull with, (poses, cables), forces; 0 of slack ones.")
      .def_property_readonly(
          "jumps", &jumps,
          "Where it leaves the poses that it goes through, a dict each: kind (\"snaps\", or "
          "\"buckles\" without a jump), the poses before and after (numbers), released (energy), "
          "moved (length), cause and strands_met.")
      .def("design", &design_at, py::arg("pose"),
           "The design in the pose of this number, to be drawn or exported; its error and "
           "certificate are not known.")
      .def("__repr__", [](const Actuated& self) {
        return "<Actuation of " + self.design.name + ": " + std::to_string(self.poses.size()) +
               " poses, " + std::to_string(self.jumps.size()) + " jumps>";
      });
  module.def("actuate", &actuate, py::arg("design"), py::arg("file"), py::arg("text"));
}

}  // namespace tencer::python
