#include "jounce/io/recording.hpp"

#include "jounce/io/points.hpp"
#include "jounce/io/units.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

void require_ascending(const Points& points, const std::vector<double>& time) {
  for (std::size_t i = 1; i < time.size(); ++i)
    if (!(time[i] > time[i - 1]))
      throw InputError("time", time[i],
                       "must be greater than " + number(time[i - 1]) + " s, the row before")
          .at(points.document, static_cast<int>(points.lines[i]));
}

std::vector<double> torques(const Points& points, const Drive& drive) {
  if (points.find("torque") != nullptr) return points.in_unit("torque", "N m");
  if (points.find("current") == nullptr) return {};
  if (drive.motor.torque_constant == 0)
    throw InputError("current", "", "needs motor.torque_constant in the drive's file")
        .at(points.document, 1);
  std::vector<double> values = points.in_unit("current", "A");
  for (double& value : values) value *= drive.motor.torque_constant;
  return values;
}

}  // namespace

Recording read_recording(const std::string& path, const Drive& drive, const std::string& position) {
  const Points points = read_points(path);
  const auto optional = [&](const char* name, const std::string& unit) {
    return points.find(name) == nullptr ? std::vector<double>{} : points.in_unit(name, unit);
  };
  Recording recording;
  recording.time = points.in_unit("time", "s");
  if (recording.time.size() < 4)
    throw InputError("time", std::to_string(recording.time.size()) + " rows",
                     "are too few for a recording: four at least")
        .at(points.document);
  require_ascending(points, recording.time);
  recording.command = points.in_unit("command", position);
  recording.position = optional("feedback", position);
  recording.velocity = optional("velocity", rate_unit(position, "s", 1));
  recording.torque = torques(points, drive);
  recording.load = optional("load", position);
  if (recording.position.empty() && recording.velocity.empty() && recording.torque.empty() &&
      recording.load.empty())
    throw InputError("feedback", "",
                     "is missing, and so are velocity, torque, current and load: one must be there")
        .at(points.document, 1);
  return recording;
}

}  // namespace jounce
