// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/detail/drive_file.hpp"

#include <fmt/format.h>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

/// The table for a prefix: "mass[1]." -> [[drive.mass]], "motor." -> [drive.motor].
std::string table_of(const std::string& part) {
  return part.starts_with("mass[") ? "[[drive.mass]]" : "[drive." + part + "]";
}

std::string limits_text(const DriveLimits& limits, const std::string& position) {
  std::string text;
  const auto add = [&](const char* key, const std::optional<double>& value,
                       const std::string& unit) {
    if (value) text += fmt::format("{} = {}  # {}\n", key, number(*value), unit);
  };
  add("torque", limits.torque, "N m");
  add("rms_torque", limits.rms_torque, "N m");
  add("current", limits.current, "A");
  add("velocity", limits.velocity, "rad/s");
  add("following_error", limits.following_error, position);
  add("end_following_error", limits.end_following_error, position);
  add("sync_following_error", limits.sync_following_error, position);
  add("residual", limits.residual, position);
  add("settling_band", limits.settling_band, position);
  add("settling_time", limits.settling_time, "s");
  return text.empty() ? text : "\n[drive.limits]\n" + text;
}

}  // namespace

std::string drive_text(const DriveSpec& spec, const Units& units, const std::string& head,
                       const std::map<std::string, std::string>& beside) {
  Drive drive = spec.drive;
  std::string text =
      fmt::format("# {}\njounce = {}\nkind = \"drive\"\n\n[units]\nposition = \"{}\"\n", head,
                  Spec::version, units.position);
  text += fmt::format("\n[drive]\nposition_per_rev = {}  # {}/rev\nsettle = {}  # s\n",
                      number(drive.position_per_rev), units.position, number(spec.settle));
  if (spec.periodic) text += "periodic = true\n";
  std::string part;
  for (const DriveNumber& n : numbers(drive)) {
    const auto dot = n.key.find('.');
    if (dot == n.key.npos) continue;  // position_per_rev, above
    if (n.key.substr(0, dot) != part) {
      part = n.key.substr(0, dot);
      text += "\n" + table_of(part) + "\n";
    }
    const bool gap = n.key.ends_with("_feed_forward") || n.key.ends_with("efficiency") ||
                     n.key.ends_with("gravity_ratio");  // their default is not 0
    if (*n.value == 0 && !gap) continue;
    text += fmt::format("{} = {}  # {}", n.key.substr(dot + 1), number(*n.value), n.unit);
    if (const auto found = beside.find(n.key); found != beside.end()) text += "; " + found->second;
    text += "\n";
  }
  for (const Interval& sync : spec.sync)
    text += fmt::format("\n[[drive.sync]]\nfrom = {}  # s\nto = {}  # s\n", number(sync.from),
                        number(sync.to));
  return text + limits_text(spec.limits, units.position);
}

}  // namespace jounce
