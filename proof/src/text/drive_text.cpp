// SPDX-License-Identifier: Apache-2.0
#include "proof/src/text/drive_text.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jounce/report/report_text.hpp"

#include "proof/src/text/loop_text.hpp"

namespace jounce {
namespace {

using Json = nlohmann::ordered_json;

std::string at(const Peak& peak, const std::string& unit) {
  return fmt::format("{} {} at {} s", rounded(peak.value), unit, rounded(peak.where));
}

std::string saturation_text(const Saturation& s) {
  return fmt::format("at the {} torque limit{} from {} to {} s", s.sign > 0 ? "upper" : "lower",
                     s.envelope ? " (lowered by speed)" : "", rounded(s.from), rounded(s.to));
}

std::string motor_text(const DriveResult& d, const Motor& m) {
  std::string text = fmt::format("motor velocity {}", at(d.velocity, "rad/s"));
  if (m.torque_constant > 0)
    text += fmt::format("; current {}, {} A rms", at(d.current, "A"), rounded(d.rms_current));
  if (m.thermal_time > 0) text += fmt::format("; I2t at most {} %", rounded(100 * d.i2t.value));
  return text;
}

std::string energy_text(const DriveResult& d, const Motor& m) {
  std::string text = fmt::format("energy {} J driving, {} J regenerated", rounded(d.energy.driving),
                                 rounded(d.energy.regenerated));
  if (m.resistance > 0) text += fmt::format(", {} J lost in copper", rounded(d.energy.copper));
  return text;
}

std::string settling_text(const DriveResult& d, const DriveLimits& limits, const std::string& u) {
  if (!limits.settling_band) return "";
  const std::string band = fmt::format("within {} {}", rounded(*limits.settling_band), u);
  return d.settling_time ? fmt::format("; {} {} s after the end", band, rounded(*d.settling_time))
                         : "; never settles " + band;
}

Json json_of(const Peak& peak) {
  return {{"value", peak.value}, {"where", peak.where}};
}

}  // namespace

std::string drive_text(const DriveResult& d, const DriveSpec& spec, const std::string& u) {
  const Drive& drive = spec.drive;
  std::string text;
  const auto line = [&](const std::string& says) {
    text += fmt::format("  {:<12} {}\n", text.empty() ? "drive" : "", says);
  };
  if (!d.integration.ok()) {
    line("BROKEN: not integrated to its end: " + d.integration.reason);
    if (const auto loop = loop_of(drive)) line("loop " + loop_text(*loop));
    return text;
  }
  line(fmt::format("{}: torque {} N m peak at {} s, {} N m rms", d.report.ok() ? "ok" : "BROKEN",
                   rounded(d.torque.value), rounded(d.torque.where), rounded(d.rms_torque)));
  if (const auto loop = loop_of(drive)) line("loop " + loop_text(*loop));
  line(motor_text(d, drive.motor));
  line(fmt::format("following error {}; {} {} at the end", at(d.following_error, u),
                   rounded(d.end_following_error), u));
  if (!spec.sync.empty())
    line(fmt::format("following error in sync {}", at(d.sync_following_error, u)));
  if (spec.periodic)
    line("over one period of the steady state");
  else
    line(fmt::format(
        "residual vibration {} {}{}{}", rounded(d.residual.value), u,
        d.residual_frequency > 0 ? fmt::format(" at {} Hz", rounded(d.residual_frequency)) : "",
        settling_text(d, spec.limits, u)));
  if (drive.pendulum) line(fmt::format("pendulum swings {}", at(d.swing, u)));
  line(energy_text(d, drive.motor));
  if (d.impacts > 0) line(fmt::format("backlash: {} impacts on a flank", d.impacts));
  constexpr std::size_t most = 8;
  for (std::size_t i = 0; i < std::min(most, d.saturation.size()); ++i)
    line(saturation_text(d.saturation[i]));
  if (d.saturation.size() > most)
    line(fmt::format("... and {} times more; --json has all", d.saturation.size() - most));
  return text;
}

nlohmann::ordered_json drive_json(const DriveResult& d, const DriveSpec& spec) {
  const Motor& m = spec.drive.motor;
  Json json{{"peak_torque", d.torque.value},
            {"rms_torque", d.rms_torque},
            {"peak_velocity", d.velocity.value},
            {"following_error", d.following_error.value},
            {"end_following_error", d.end_following_error},
            {"residual", d.residual.value},
            {"residual_frequency", d.residual_frequency}};
  if (!spec.sync.empty()) json["sync_following_error"] = d.sync_following_error.value;
  if (m.torque_constant > 0) {
    json["peak_current"] = d.current.value;
    json["rms_current"] = d.rms_current;
  }
  if (m.thermal_time > 0) json["i2t"] = json_of(d.i2t);
  if (spec.limits.settling_band)
    json["settling_time"] = d.settling_time ? Json(*d.settling_time) : Json(nullptr);
  if (spec.drive.pendulum) json["swing"] = d.swing.value;
  json["energy"] = {{"driving", d.energy.driving}, {"regenerated", d.energy.regenerated}};
  if (m.resistance > 0) json["energy"]["copper"] = d.energy.copper;
  json["impacts"] = d.impacts;
  json["saturations"] = d.saturation.size();
  json["saturation"] = Json::array();
  for (const Saturation& s : d.saturation)
    json["saturation"].push_back(
        {{"from", s.from}, {"to", s.to}, {"sign", s.sign}, {"envelope", s.envelope}});
  if (const auto loop = loop_of(spec.drive)) json["loop"] = loop_json(*loop);
  json["steps"] = d.integration.steps;
  json["restarts"] = d.integration.restarts;
  return json;
}

}  // namespace jounce
