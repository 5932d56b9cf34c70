// SPDX-License-Identifier: Apache-2.0
#include "design/src/check/master_check.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "jounce/base/units.hpp"
#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/detail/tolerances.hpp"
#include "jounce/report/report_text.hpp"

#include "design/src/check/step_check.hpp"

namespace jounce {

using design_detail::usual_cycle;

bool has_slave_limits(const Spec& spec) {
  const Limits& slave = spec.slave;
  return slave.velocity || slave.acceleration || slave.jerk;
}

std::string master_rate_unit(const Spec& spec, int order) {
  return rate_unit(spec.units.x, spec.time_unit, order);
}

SpeedUnit master_speed_unit(const Spec& spec) {
  const std::string own = master_rate_unit(spec, 1);
  const std::string unit = spec.document.given_unit("master.velocity", own);
  if (is_convertible(unit, own)) return {unit, conversion(unit, own)};
  const double cycle = spec.master_period().value_or(1);
  return {unit, conversion(unit, rate_unit("", spec.time_unit, 1)) * cycle};
}

std::string slave_rate_unit(const Spec& spec, int order) {
  const std::string key =
      std::string("limits.slave.") + OverTime::names[static_cast<std::size_t>(order)];
  return spec.document.given_unit(key, rate_unit(spec.units.position, spec.time_unit, order));
}

MasterRates master_rates(const Spec& spec) {
  if (!spec.master) return {0, 0, usual_cycle(spec.time_unit)};
  return {spec.master->acceleration.value_or(0), 0, usual_cycle(spec.time_unit)};
}

namespace {

MasterLimit acceleration_at(const Cam& cam, const Spec& spec, double velocity) {
  return greatest_master_acceleration(cam, spec.slave, velocity, 0, usual_cycle(spec.time_unit));
}

}  // namespace

bool master_accelerates_too_fast(const Cam& cam, const Spec& spec) {
  const double given = master_rates(spec).acceleration;
  const double most = acceleration_at(cam, spec, 0).value;
  return given > most &&
         greatest_master_velocity(cam, spec.slave, {0, 0, usual_cycle(spec.time_unit)}).value > 0;
}

MasterLimit greatest_master_acceleration(const Cam& cam, const Spec& spec) {
  const MasterLimit running = acceleration_at(cam, spec, spec.master->velocity);
  return running.value > 0 ? running : acceleration_at(cam, spec, 0);
}

MasterSpeed fastest_master_with_ramp(const Cam& cam, const Spec& spec) {
  const double given = spec.master->velocity;
  const double running = acceleration_at(cam, spec, given).value;
  if (running > 0) return {given, running};
  const double half = acceleration_at(cam, spec, 0).value / 2;
  return {greatest_master_velocity(cam, spec.slave, {half, 0, usual_cycle(spec.time_unit)}).value,
          half};
}

namespace {

using profiles_detail::rounded_sum;

/// A greatest speed of the master in the unit of the spec, rounded down: "96.4 cpm".
std::string speed_text(double speed, const Spec& spec) {
  const SpeedUnit unit = master_speed_unit(spec);
  return six_digits_down(speed / unit.size) + " " + unit.name;
}

/// The quantity whose step makes this one unbounded.
const char* before(const std::string& quantity) {
  if (quantity == "velocity") return "position";
  return quantity == "acceleration" ? "velocity" : "acceleration";
}

/// For a ramp of a shear that is computed from the limits: the factor that leaves a reserve for what the changing
/// speed of the master adds. Twice the length of a ramp halves its acceleration, and more than halves its jerk.
std::string longer_ramp(const Finding& f, const Spec& spec) {
  const auto* sync = std::get_if<SyncSpec>(&spec.subject);
  const auto* shear = sync == nullptr ? nullptr : std::get_if<FlyingShear>(sync);
  const double added = std::abs(f.value) - std::abs(f.limit);
  const double reserve = std::abs(f.limit) - added;
  if (shear == nullptr || shear->acceleration_length || f.quantity == OverTime::names[1] ||
      !(master_rates(spec).acceleration > 0) || !(reserve > 0))
    return "";
  constexpr double digits = 100;
  const double factor = shear->safety * std::abs(f.limit) / reserve;
  return "give safety = " + six_digits(std::ceil(factor * digits) / digits) +
         " in [shear], for longer ramps";
}

/// Ways to keep a limit of the slave. `fastest`: 0 if no speed of the master keeps it.
std::string slave_advice(const Finding& f, double fastest, const Spec& spec) {
  std::string text = longer_ramp(f, spec);
  if (std::holds_alternative<CamSpec>(spec.subject))
    text =
        fmt::format("lengthen the segment, or use a law with a lower {} coefficient", f.quantity);
  if (fastest > 0)
    text += (text.empty() ? "slow the master down to " : ", or slow the master down to ") +
            speed_text(fastest, spec);
  return text;
}

}  // namespace

Report check_slave(const Cam& cam, const Spec& spec) {
  const MasterRates rates = master_rates(spec);
  Report report = check_slave(cam, spec.slave, spec.master->velocity, rates);
  const double fastest = report.ok() ? 0 : greatest_master_velocity(cam, spec.slave, rates).value;
  for (Finding& f : report.findings) {
    const auto name = std::find(OverTime::names.begin(), OverTime::names.end(), f.quantity);
    const int order = static_cast<int>(name - OverTime::names.begin());
    f.unit = slave_rate_unit(spec, order);
    const double size = conversion(rate_unit(spec.units.position, spec.time_unit, order), f.unit);
    f.value *= size;
    f.limit *= size;
    if (f.broken) f.advice = slave_advice(f, fastest, spec);
  }
  return report;
}

namespace {

Finding acceleration_finding(const Cam& cam, const Spec& spec) {
  const MasterLimit limit = greatest_master_acceleration(cam, spec);
  Finding f;
  const MasterSpeed most = fastest_master_with_ramp(cam, spec);
  f.rule = "limit/master_acceleration";
  f.quantity = "master_acceleration";
  f.where = limit.where;
  f.value = master_rates(spec).acceleration;
  f.limit = limit.value;
  f.margin = limit.value > 0 ? 1 - f.value / limit.value : -f.value;
  f.broken = true;
  f.unit = master_rate_unit(spec, 2);
  f.advice = fmt::format(
      "while the master accelerates, the slave exceeds limits.slave.{} even at low speed: lower "
      "acceleration in [master] to at most {} {}{}",
      limit.quantity, six_digits_down(most.acceleration), f.unit,
      most.velocity < spec.master->velocity
          ? ", and velocity to at most " + speed_text(most.velocity, spec)
          : "");
  return f;
}

}  // namespace

Finding master_finding(const Cam& cam, const Spec& spec) {
  if (master_accelerates_too_fast(cam, spec)) return acceleration_finding(cam, spec);
  const SpeedUnit unit = master_speed_unit(spec);
  const double speed = spec.master->velocity;
  const MasterLimit limit = greatest_master_velocity(cam, spec.slave, master_rates(spec));
  Finding f;
  f.rule = "limit/master_velocity";
  f.quantity = "master_velocity";
  f.where = limit.where;
  f.value = speed / unit.size;
  f.limit = limit.value / unit.size;
  f.margin = limit.value > 0 ? 1 - speed / limit.value : -speed;
  f.broken = speed > limit.value * (1 + rounded_sum);
  f.unit = unit.name;
  if (f.broken && limit.value == 0)  // a step: of the velocity for the acceleration, ...
    f.advice = fmt::format(
        "no speed of the master keeps limits.slave.{} at this place, because the {} of the cam "
        "steps there: remove the step",
        limit.quantity, before(limit.quantity));
  else if (f.broken && limit.is_step)
    f.advice = fmt::format(
        "the {} of the cam steps there, and in one cycle of 1 ms limits.slave.{} permits no "
        "greater "
        "step: remove the step, or slow the master down",
        before(limit.quantity), limit.quantity);
  else if (f.broken)
    f.advice = "there the slave reaches limits.slave." + limit.quantity + ": slow the master down";
  return f;
}

}  // namespace jounce
