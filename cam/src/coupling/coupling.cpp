// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/coupling/coupling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "jounce/profiles/curve/modulo.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/src/coupling/settle.hpp"

// The difference between slave and cam at the start is
//
//   (1)  d = (y - Y, y' - Y', y'' - Y''),   Y by the chain rule from the master's jet
//
// The setpoint Y + c with c(0) = d continues the slave's motion. c is a move from d to rest at
// zero. For a rotary slave with period P, a cam that is shifted by k P is equivalent. Then c moves
// from d to (k P, 0, 0), the origin of the cam moves by k P, and c is relative to the new origin:
//
//   (2)  y = (Y + k P) + (c - k P)
//
// Over the master, c is a function of x with c = d0, c_x x' = d1 and c_xx x'^2 + c_x x'' = d2. So
//
//   (3)  c_x = d1 / x',   c_xx = (d2 - c_x x'') / x'^2;   at x' = 0:  c_x = d2 / x'',  c_xx = 0
//
// A master at rest can correct only differences with d1 = 0; if its acceleration is 0 as well, only
// those with d2 = 0.

namespace jounce {
namespace {

bool over_time(StartMode mode) {
  return mode == StartMode::ramp_in || mode == StartMode::ramp_in_pos ||
         mode == StartMode::ramp_in_neg;
}

void require_some(const char* key, const std::optional<double>& value, StartMode mode) {
  if (!value)
    throw InputError(key, "", std::string("is missing: start = \"") + name(mode) + "\" needs it");
}

bool finite(const MotionState& s) {
  return std::isfinite(s.position) && std::isfinite(s.velocity) && std::isfinite(s.acceleration);
}

/// The bounds of a correction in this direction: it speeds up with `acceleration` and slows down
/// with `deceleration`.
Bounds bounds_of(const CouplingSpec& spec, double direction) {
  Bounds bounds = within(*spec.velocity_diff, *spec.acceleration, spec.jerk.value_or(Bounds::none));
  const double deceleration = spec.deceleration.value_or(*spec.acceleration);
  if (direction < 0)
    bounds.acceleration_max = deceleration;
  else
    bounds.acceleration_min = -deceleration;
  return bounds;
}

double whole_periods(double x, double period) {
  return period * std::nearbyint(x / period);
}

/// The end of the correction of a rotary slave, which is a multiple of its period: (2). A target
/// that is behind by at most `near` counts as ahead.
double rotary_target(const MotionState& d, const CouplingSpec& spec, double near) {
  const double period = *spec.slave_period;
  const double nearest = whole_periods(d.position, period);
  if (!over_time(spec.start)) return nearest;
  const auto [direction, sign] = [&] {
    if (spec.start == StartMode::ramp_in_pos) return std::pair{Direction::positive, 1.0};
    if (spec.start == StartMode::ramp_in_neg) return std::pair{Direction::negative, -1.0};
    return std::pair{Direction::fastest, nearest - d.position};
  }();
  MotionState from = d;
  if (direction != Direction::fastest) from.position -= sign * near;
  const ModuloTarget target = modulo_target(from, 0, direction, period, bounds_of(spec, sign));
  return target.status == MoveStatus::ok ? whole_periods(target.position, period) : nearest;
}

/// True if a correction from d to zero moves only in the requested direction. Exceptions: `near`,
/// and the braking of a slave that first moves the other way.
bool goes_the_way(const MotionState& d, const CouplingSpec& spec, const Bounds& bounds,
                  double near) {
  if (spec.start == StartMode::ramp_in) return true;
  const double sign = spec.start == StartMode::ramp_in_pos ? 1 : -1;
  const MoveResult halt = stop(d, bounds);
  return sign * (halt ? halt.profile.end().position : d.position) <= near;
}

/// True if the slave is on its cam to rounding, so that no correction is necessary.
bool is_there(const MotionState& d, const CouplingSpec& spec, const Jet& near) {
  const double off =
      spec.slave_period ? d.position - whole_periods(d.position, *spec.slave_period) : d.position;
  return std::abs(off) <= near[0] && std::abs(d.velocity) <= near[1] &&
         std::abs(d.acceleration) <= near[2];
}

CouplingStatus ramp_over_time(const MotionState& d, const CouplingSpec& spec, double near, double t,
                              Correction& correction) {
  const double direction = spec.start == StartMode::ramp_in_pos   ? 1
                           : spec.start == StartMode::ramp_in_neg ? -1
                                                                  : -d.position;
  const Bounds bounds = bounds_of(spec, direction);
  if (!goes_the_way(d, spec, bounds, near)) return CouplingStatus::would_reverse;
  const MoveResult move = move_to(d, {}, bounds);
  if (!move) return CouplingStatus::no_ramp;
  correction = Correction::over_time(move.profile, t);
  return CouplingStatus::ok;
}

CouplingStatus ramp_over_master(const MotionState& d, const CouplingSpec& spec, const Jet& x,
                                Correction& correction) {
  Jet c{d.position, 0, 0, 0};  // (3)
  if (x[1] != 0) {
    c[1] = d.velocity / x[1];
    c[2] = (d.acceleration - c[1] * x[2]) / (x[1] * x[1]);
  } else if (d.velocity != 0 || (d.acceleration != 0 && x[2] == 0)) {
    return CouplingStatus::master_stands;
  } else if (x[2] != 0) {
    c[1] = d.acceleration / x[2];
  }
  if (!std::isfinite(c[1]) || !std::isfinite(c[2])) return CouplingStatus::master_stands;
  correction = Correction::over_master(c, x[0], *spec.distance);
  return correction.finite() ? CouplingStatus::ok : CouplingStatus::no_ramp;
}

}  // namespace

void require_valid(const CouplingSpec& spec) {
  require_positive("master_scaling", spec.master_scaling);
  require_finite("master_offset", spec.master_offset);
  require_positive("slave_scaling", spec.slave_scaling);
  require_finite("slave_offset", spec.slave_offset);
  const std::array<std::pair<const char*, const std::optional<double>*>, 7> magnitudes{
      {{"velocity_diff", &spec.velocity_diff},
       {"acceleration", &spec.acceleration},
       {"deceleration", &spec.deceleration},
       {"jerk", &spec.jerk},
       {"distance", &spec.distance},
       {"slave_period", &spec.slave_period},
       {"master_jump", &spec.master_jump}}};
  for (const auto& [key, value] : magnitudes)
    if (*value) require_positive(key, **value);
  if (over_time(spec.start)) {
    require_some("velocity_diff", spec.velocity_diff, spec.start);
    require_some("acceleration", spec.acceleration, spec.start);
  }
  if (spec.start == StartMode::ramp_in_distance)
    require_some("distance", spec.distance, spec.start);
}

Coupling::Coupling(Cam cam, const CouplingSpec& spec) : cam_(std::move(cam)), spec_(spec) {
  require_valid(spec_);
  const Extrapolation outside = cam_.outside();
  const Ranges f = extrema(cam_);
  const double k = spec_.master_scaling;
  reach_ = {spec_.slave_scaling * (f[0].max.value - f[0].min.value),
            spec_.slave_scaling * k * std::abs(f[1].peak().value),
            spec_.slave_scaling * k * k * std::abs(f[2].peak().value), 0};
  placement_ = {.master_scaling = spec_.master_scaling,
                .master_offset = spec_.master_offset,
                .slave_scaling = spec_.slave_scaling,
                .slave_offset = spec_.slave_offset,
                .periodic = outside != Extrapolation::refuse && outside != Extrapolation::hold};
  if (!placement_.periodic) return;
  const double begin = cam_.jet(cam_.start())[0];
  const double end = cam_.jet(cam_.end(), Side::left)[0];
  const double stroke = spec_.slave_scaling * (end - begin);
  // A cam that wraps returns to its start, unless the slave advances in each period.
  if (slave_relative() || outside != Extrapolation::wrap)
    placement_.advance = stroke;
  else if (spec_.slave_period)
    placement_.advance = whole_periods(stroke, *spec_.slave_period);
  period_jump_ = placement_.advance - stroke;
}

bool Coupling::slave_relative() const {
  return spec_.start == StartMode::relative || !spec_.slave_absolute;
}

namespace cam_detail {

Jet roundings(const Coupling& coupling, const MotionState& slave, const Jet& y, const Jet& x) {
  const Jet& reach = coupling.reach();
  const double far = std::max(std::abs(slave.position), std::abs(y[0]));
  return {
      std::max(1e-9 * reach[0], 1e-12 * far),
      1e-9 * (reach[1] * std::abs(x[1]) + std::abs(slave.velocity)),
      1e-9 * (reach[2] * x[1] * x[1] + reach[1] * std::abs(x[2]) + std::abs(slave.acceleration)),
      0};
}

bool has_numbers(const CouplingSpec& spec, StartMode start) {
  if (start == StartMode::ramp_in_distance) return spec.distance.has_value();
  return !over_time(start) || (spec.velocity_diff && spec.acceleration);
}

Engagement settle(const Coupling& coupling, StartMode start, const Placement& placement,
                  const MotionState& slave, const Jet& master, double t) {
  CouplingSpec spec = coupling.spec();
  spec.start = start;
  Engagement e{.engaged = {placement, {}, t, master}};
  const Jet y = placed(coupling.cam(), placement, master);
  MotionState d{slave.position - y[0], slave.velocity - y[1], slave.acceleration - y[2]};  // (1)
  if (!finite(d)) e.status = CouplingStatus::not_finite;
  if (!e) return e;
  const Jet near = roundings(coupling, slave, y, master);
  if (over_time(start) && is_there(d, spec, near)) spec.start = StartMode::ramp_in;
  if (spec.slave_period) {
    if (!std::isfinite(d.position / *spec.slave_period)) e.status = CouplingStatus::no_ramp;
    if (!e) return e;
    const double target = rotary_target(d, spec, near[0]);
    e.engaged.placement.slave_offset += target;  // (2)
    d.position -= target;
  }
  if (over_time(spec.start))
    e.status = ramp_over_time(d, spec, near[0], t, e.engaged.correction);
  else if (spec.start == StartMode::ramp_in_distance)
    e.status = ramp_over_master(d, spec, master, e.engaged.correction);
  else
    e.jump = {0 - d.position, 0 - d.velocity, 0 - d.acceleration};  // not -0
  return e;
}

}  // namespace cam_detail

Engagement engage(const Coupling& coupling, const MotionState& slave, const Jet& master, double t) {
  const CouplingSpec& spec = coupling.spec();
  const Cam& cam = coupling.cam();
  Placement p = coupling.placement();
  const bool sound =
      finite(slave) && std::isfinite(t) &&
      std::all_of(master.begin(), master.end(), [](double v) { return std::isfinite(v); });
  if (!sound) return {.status = CouplingStatus::not_finite, .engaged = {p, {}, 0, {}}};
  if (!spec.master_absolute) p.master_offset -= p.master_scaling * master[0];
  if (cam.outside() == Extrapolation::refuse &&
      !spot(p.at(master[0]), cam.start(), cam.length(), false).inside)
    return {.status = CouplingStatus::master_outside_cam, .engaged = {p, {}, t, master}};
  if (coupling.slave_relative()) {
    p.slave_offset = 0;
    p.slave_offset = slave.position - placed(cam, p, master)[0] + spec.slave_offset;
  }
  return cam_detail::settle(coupling, spec.start, p, slave, master, t);
}

const char* name(StartMode mode) {
  constexpr std::array<const char*, start_mode_count> names{
      "absolute", "relative", "ramp_in", "ramp_in_pos", "ramp_in_neg", "ramp_in_distance"};
  return names[static_cast<std::size_t>(mode)];
}

namespace {

struct Words {
  const char* name;
  const char* meaning;
};
constexpr std::array<Words, 7> statuses{{
    {"ok", "The slave can be coupled."},
    {"not_finite", "A position, velocity or acceleration, or the time, is not a finite number."},
    {"master_outside_cam", "The master is outside the range of a cam that rejects this."},
    {"would_reverse",
     "The slave could reach its cam only against the direction that its start mode allows."},
    {"master_stands",
     "The slave moves but the master stands, so a ramp over a master distance cannot end."},
    {"no_ramp", "No correction within these limits brings the slave onto its cam."},
    {"window_missed",
     "The master passed the engage position, but in no cycle was it within the window."},
}};

}  // namespace

const char* name(CouplingStatus status) {
  return statuses[static_cast<std::size_t>(status)].name;
}

const char* explain(CouplingStatus status) {
  return statuses[static_cast<std::size_t>(status)].meaning;
}

}  // namespace jounce
