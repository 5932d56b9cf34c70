// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include <yaml-cpp/yaml.h>

#include "jounce/profiles/error.hpp"

#include "controllers/src/exchange/cells.hpp"
#include "controllers/src/exchange/formats.hpp"

// A message trajectory_msgs/JointTrajectory of ROS as YAML. Each point has the positions of all
// joints, perhaps their velocities and accelerations, and the time from the start. The joint
// trajectory controller of ros2_controllers moves on straight lines, on polynomials of degree 3, or
// of degree 5, by which of these are given.
namespace jounce::controllers_detail {
namespace {

constexpr double in_a_second = 1e9;  ///< ns

int line_of(const YAML::Node& node) {
  return node.Mark().is_null() ? 0 : node.Mark().line + 1;
}

/// The points of a message.
class Message {
 public:
  Message(const YAML::Node& root, const Place& place) : place_(place) {
    const YAML::Node names = member(root, "joint_names", "joint_names");
    const YAML::Node points = member(root, "points", "points");
    if (!names.IsSequence() || names.size() == 0)
      place.fail(line_of(root), "joint_names", "", "must be a list of one name or more");
    if (!points.IsSequence() || points.size() == 0)
      place.fail(line_of(root), "points", "", "must be a list of points");
    for (const YAML::Node& name : names) joints_.push_back({.name = scalar(name, "joint_names")});
    for (std::size_t i = 0; i < points.size(); ++i)
      read_point(points[i], "points[" + std::to_string(i + 1) + "]");
  }

  std::vector<Exchanged> joints() { return std::move(joints_); }

 private:
  YAML::Node member(const YAML::Node& of, const char* name, const std::string& key) const {
    if (!of.IsMap()) place_.fail(line_of(of), key, "", "must have keys");
    const YAML::Node found = of[name];
    return found.IsDefined() ? found : YAML::Node();
  }

  std::string scalar(const YAML::Node& node, const std::string& key) const {
    if (!node.IsScalar()) place_.fail(line_of(node), key, "", "must be one value");
    return node.Scalar();
  }

  double number_of(const YAML::Node& node, const std::string& key) const {
    return place_.number(line_of(node), key, scalar(node, key));
  }

  void read_point(const YAML::Node& point, const std::string& key) {
    const double time = time_of(point, key + ".time_from_start");
    bool given = true;
    for (std::size_t column = 0; column < 3; ++column) {
      static constexpr std::array names{"positions", "velocities", "accelerations"};
      const YAML::Node values = member(point, names[column], key);
      const bool has = values.IsSequence() && values.size() > 0;
      if (has && !given)
        place_.fail(line_of(values), key + "." + names[column], "",
                    std::string("needs ") + names[column - 1]);
      given = has;
      if (column == 0 && !has) place_.fail(line_of(point), key + ".positions", "", "is missing");
      require_same(point, column, has, key + "." + names[column]);
      if (!has) continue;
      if (values.size() != joints_.size())
        place_.fail(line_of(values), key + "." + names[column],
                    std::to_string(values.size()) + " values",
                    "must have one value for each joint: " + std::to_string(joints_.size()));
      for (std::size_t i = 0; i < joints_.size(); ++i) {
        Columns& to = joints_[i].columns;
        std::array{&to.p, &to.v, &to.a}[column]->push_back(
            number_of(values[i], key + "." + names[column]));
      }
    }
    if (const YAML::Node effort = member(point, "effort", key);
        effort.IsSequence() && effort.size() > 0)
      for (Exchanged& joint : joints_)
        if (joint.unread.empty()) joint.unread.emplace_back("the efforts are not read");
    for (Exchanged& joint : joints_) {
      joint.columns.x.push_back(time);
      joint.lines.push_back(line_of(point));
    }
  }

  /// The first point decides which columns all points have.
  void require_same(const YAML::Node& point, std::size_t column, bool has, const std::string& key) {
    static constexpr std::array rules{Interpolation::linear, Interpolation::cubic_hermite,
                                      Interpolation::quintic_hermite};
    if (joints_.front().lines.empty() && has)
      for (Exchanged& joint : joints_) joint.rule = rules[column], joint.units = {"s", ""};
    if (!joints_.front().lines.empty() && has != (joints_.front().rule >= rules[column]))
      place_.fail(line_of(point), key, "",
                  has ? "must be in all points or in none" : "is missing: the first point has it");
  }

  /// Seconds; ROS 1 has the names secs and nsecs.
  double time_of(const YAML::Node& point, const std::string& key) const {
    const YAML::Node time = member(point, "time_from_start", key);
    if (!time.IsMap()) place_.fail(line_of(point), key, "", "is missing");
    const bool first = time["secs"].IsDefined();
    const auto part = [&](const char* name) {
      const YAML::Node node = time[name];
      return node.IsDefined() ? number_of(node, key + "." + name) : 0.0;
    };
    const double seconds = part(first ? "secs" : "sec"), rest = part(first ? "nsecs" : "nanosec");
    if (seconds != std::floor(seconds) || rest != std::floor(rest) ||
        !(rest >= 0 && rest < in_a_second))
      place_.fail(line_of(time), key, number(seconds) + ", " + number(rest),
                  "must be whole numbers, the nanoseconds from 0 to 999999999");
    return (seconds * in_a_second + rest) / in_a_second;
  }

  const Place& place_;
  std::vector<Exchanged> joints_ = {};
};

std::vector<Exchanged> read_ros(const std::string& text, const Place& place) {
  try {
    YAML::Node root = YAML::Load(text);
    if (root.IsMap() && root["trajectory"].IsDefined()) root.reset(root["trajectory"]);
    return Message(root, place).joints();
  } catch (const YAML::Exception& error) {
    place.fail(error.mark.is_null() ? 1 : error.mark.line + 1, "", "",
               "is not a JointTrajectory in YAML: " + error.msg);
  }
}

std::string ros_text(const TableFile& file) {
  const Columns& c = file.table.columns();
  std::string text = "# a motion for ROS, by " + made_by() +
                     "\n# position: " + file.units.position + "\njoint_names: [joint1]\npoints:\n";
  for (std::size_t i = 0; i < c.x.size(); ++i) {
    const auto ns = std::llround((c.x[i] - c.x[0]) * in_a_second);
    constexpr auto second = static_cast<long long>(in_a_second);
    text += "- {positions: [" + number(c.p[i]) + "], velocities: [" + number(c.v[i]) +
            "], accelerations: [" + number(c.a[i]) +
            "], time_from_start: {sec: " + std::to_string(ns / second) +
            ", nanosec: " + std::to_string(ns % second) + "}}\n";
  }
  return text;
}

}  // namespace

constinit const FormatRow ros_format{
    .format = {.name = "ros",
               .maker = "ROS, trajectory_msgs/JointTrajectory as YAML",
               .knot = "a point: positions, velocities, accelerations, time_from_start",
               .source = "ROS 2, trajectory_msgs; ros2_controllers, joint_trajectory_controller",
               .extension = ".yaml",
               .join = KnotJoin::quintic,
               .axis = Domain::time,
               .x_unit = "s",
               .position_units = "m rad",
               .x_rounding = 1 / in_a_second,
               .keeps_units = true,
               .not_kept =
                   "the name of the joint is joint1; the times count from the start of the table"},
    .detects =
        [](const std::string& text) {
          return text.find("joint_names") != text.npos && text.find("time_from_start") != text.npos;
        },
    .read = read_ros,
    .write = ros_text};

}  // namespace jounce::controllers_detail
