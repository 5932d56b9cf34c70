// SPDX-License-Identifier: Apache-2.0
#include "jounce/drive/machine_sensors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "jounce/profiles/error.hpp"

namespace jounce {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::optional<SimulatedSwitch> simulated(const std::string& key,
                                         const std::optional<MachineSwitch>& spec) {
  if (!spec) return std::nullopt;
  try {
    return SimulatedSwitch(*spec);
  } catch (const InputError& error) {
    throw InputError(key + "." + error.key(), error.value(), error.rule());
  }
}

/// True if the motion from one position to another passes `place`; a position that is just reached
/// counts as passed upwards.
bool passes(double place, double from, double to) {
  return (from < place) != (to < place);
}

}  // namespace

SimulatedSwitch::SimulatedSwitch(const MachineSwitch& spec) : spec_(spec) {
  require_finite("position", spec.position);
  if (!(spec.width > 0)) throw InputError("width", spec.width, "must be greater than 0");
  require_not_negative("bounce", spec.bounce);
}

bool SimulatedSwitch::at(double position) const noexcept {
  const bool inside = position >= spec_.position && position < spec_.position + spec_.width;
  return inside != spec_.inverted;
}

Sensor SimulatedSwitch::step(double from, double to, double dt) noexcept {
  Sensor now{.wired = true, .on = at(to)};
  for (const double edge : {spec_.position, spec_.position + spec_.width})
    if (passes(edge, from, to) && !(std::abs(now.edge - from) <= std::abs(edge - from)))
      now.edge = edge;
  if (std::isfinite(now.edge)) {
    bouncing_ = spec_.bounce;
    flipped_ = false;
    return now;
  }
  bouncing_ = std::max(bouncing_ - dt, 0.0);
  const bool before = std::exchange(flipped_, bouncing_ > 0 && !flipped_);
  if (flipped_ != before) now.edge = to;
  now.on = now.on != flipped_;
  return now;
}

double index_between(const MachineIndex& index, double from, double to) noexcept {
  const double before = std::floor((from - index.offset) / index.period);
  const double after = std::floor((to - index.offset) / index.period);
  if (before == after) return none;
  return index.offset + index.period * (after > before ? before + 1 : before);
}

SimulatedMarks::SimulatedMarks(const MachineMarks& spec) : spec_(spec) {
  if (spec.input < 1 || spec.input > Triggers::most_inputs)
    throw InputError("input", std::to_string(spec.input), "must be 1 to 4");
  require_finite("first", spec.first);
  require_positive("distance", spec.distance);
  require_positive("width", spec.width);
  require_not_negative("wander", spec.wander);
  require_positive("wander_marks", spec.wander_marks);
  if (!(spec.width < spec.distance / 2))
    throw InputError("width", spec.width, "must be less than half the distance of the marks");
  if (!(spec.wander < spec.distance / 4))
    throw InputError("wander", spec.wander, "must be less than a quarter of the distance");
  std::sort(spec_.missing.begin(), spec_.missing.end());
}

double SimulatedMarks::place(double mark) const noexcept {
  const double angle = 2 * std::numbers::pi * mark / spec_.wander_marks;
  return spec_.first + mark * spec_.distance + spec_.wander * std::sin(angle);
}

bool SimulatedMarks::exists(double mark) const noexcept {
  if (!(mark >= 0) || (spec_.count && mark >= static_cast<double>(*spec_.count))) return false;
  constexpr double most = 1e15;  // fits the number of a mark
  return mark < most && !std::binary_search(spec_.missing.begin(), spec_.missing.end(),
                                            static_cast<std::int64_t>(mark));
}

/// Calls f(position) for the marks that may be on between two positions.
template <class F>
void SimulatedMarks::each_near(double low, double high, F f) const {
  const double margin = spec_.wander + spec_.width;
  const double first = std::max(std::floor((low - margin - spec_.first) / spec_.distance), 0.0);
  const double last = std::ceil((high + margin - spec_.first) / spec_.distance);
  constexpr int most = 1000;  // in one cycle
  for (int i = 0; i <= most && first + i <= last; ++i)
    if (exists(first + i)) f(place(first + i));
  for (const double extra : spec_.extra) f(extra);
}

bool SimulatedMarks::at(double position) const noexcept {
  bool on = false;
  each_near(position, position,
            [&](double mark) { on = on || (position >= mark && position < mark + spec_.width); });
  return on;
}

void SimulatedMarks::step(double from, double to, double dt, double ago,
                          Triggers& triggers) const noexcept {
  const auto bit = static_cast<std::uint8_t>(1U << (spec_.input - 1));
  triggers.wired |= bit;
  if (!std::isfinite(from) || !std::isfinite(to)) return;
  if (at(to)) triggers.on |= bit;
  const auto add = [&](double edge, bool begins) {
    if (!passes(edge, from, to) || triggers.count == Triggers::most_changes) return;
    const double age = ago + dt * (to - edge) / (to - from);
    triggers.change[triggers.count++] = {.input = static_cast<std::uint8_t>(spec_.input),
                                         .rising = begins == (to > from),
                                         .age = age,
                                         .position = spec_.on_master ? none : edge};
  };
  each_near(std::min(from, to), std::max(from, to), [&](double mark) {
    add(mark, true);
    add(mark + spec_.width, false);
  });
}

DriveOnMachine::DriveOnMachine(std::shared_ptr<AxisDrive> drive, const MachineSensorsSpec& spec,
                               double period)
    : drive_(std::move(drive)),
      spec_(spec),
      period_(period),
      home_(simulated("machine.home_switch", spec.home)),
      negative_(simulated("machine.negative_switch", spec.negative)),
      positive_(simulated("machine.positive_switch", spec.positive)) {
  require_finite("machine.encoder_offset", spec.encoder_offset);
  for (const MachineMarks& marks : spec.marks) {
    try {
      marks_.emplace_back(marks);
    } catch (const InputError& error) {
      throw InputError("machine.marks[" + std::to_string(marks_.size() + 1) + "]." + error.key(),
                       error.value(), error.rule());
    }
  }
  if (!spec.index) return;
  require_positive("machine.index.period", spec.index->period);
  require_finite("machine.index.offset", spec.index->offset);
}

Feedback DriveOnMachine::feedback() noexcept {
  Feedback said = drive_->feedback();
  const double to = said.position + spec_.encoder_offset;
  const double from = last_.value_or(to);
  last_ = to;
  Sensors& sensors = said.sensors;
  sensors.home = latched(home_, from, to);
  sensors.negative = latched(negative_, from, to);
  sensors.positive = latched(positive_, from, to);
  sensors.index.wired = spec_.index.has_value();
  if (spec_.index)
    sensors.index.edge = index_between(*spec_.index, from, to) - spec_.encoder_offset;
  if (!marks_.empty()) detect(from, to, said.triggers);
  return said;
}

void DriveOnMachine::command(const DriveSetpoint& setpoint) noexcept {
  last_master_ = std::exchange(master_, setpoint.master);
  before_ = std::exchange(commanded_, setpoint.tick);
  tick_ = setpoint.tick + 1;
  drive_->command(setpoint);
}

void DriveOnMachine::begin(std::int64_t tick) noexcept {
  tick_ = tick;
  drive_->begin(tick);
}

void DriveOnMachine::detect(double from, double to, Triggers& triggers) noexcept {
  const double ago = static_cast<double>(tick_ - commanded_) * period_;
  const double step = static_cast<double>(commanded_ - before_) * period_;
  for (const SimulatedMarks& marks : marks_) {
    if (marks.spec().on_master)
      marks.step(last_master_, master_, step, ago, triggers);
    else
      marks.step(from, to, ago, 0, triggers);
  }
  const auto changes = triggers.change.begin();
  for (auto change = changes; change != changes + triggers.count; ++change)
    change->position -= spec_.encoder_offset;
  std::sort(changes, changes + triggers.count,
            [](const TriggerChange& a, const TriggerChange& b) { return a.age > b.age; });
}

/// Converts to the coordinate of the encoder.
Sensor DriveOnMachine::latched(std::optional<SimulatedSwitch>& of, double from,
                               double to) noexcept {
  if (!of) return {};
  Sensor sensor = of->step(from, to, period_);
  sensor.edge -= spec_.encoder_offset;
  return sensor;
}

}  // namespace jounce
