// SPDX-License-Identifier: Apache-2.0
#include "executor/src/server/events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jounce {
namespace {

constexpr std::int64_t most_marks = 8;            // events of a kind in one cycle
constexpr std::int64_t most_number = 0x7fffffff;  // greatest number of an event in a message

/// One end of a step: position and velocity of the signal of the switches.
struct End {
  double position = 0;
  double velocity = 0;
};

End end_of(const Tick& tick, SwitchesOf of) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  if (of == SwitchesOf::master) return {tick.master, tick.master_velocity};
  if (of == SwitchesOf::actual) return {tick.actual_position, unknown};
  return {tick.position, tick.velocity};
}

/// The cubic through both ends, t seconds after the first of dt; a straight line if the velocities
/// are not available.
double between(const End& a, const End& b, double t, double dt) {
  const double s = t / dt;
  const double way = b.position - a.position;
  if (!std::isfinite(a.velocity + b.velocity)) return a.position + s * way;
  const double bend = (1 - s) * (a.velocity * dt - way) - s * (b.velocity * dt - way);
  return a.position + s * way + s * (1 - s) * bend;
}

}  // namespace

std::vector<wire::Event> events_of(const Tick& before, const Tick& now, SwitchesOf of,
                                   std::int64_t period, std::int64_t last_count) {
  std::vector<wire::Event> events;
  const double dt = static_cast<double>((now.skipped + 1) * period) * 1e-9;
  const auto note = [&](wire::EventKind kind, std::uint32_t number, bool on, double age,
                        double position) {
    if (!std::isfinite(position)) position = 0;
    events.push_back({.kind = kind,
                      .number = number,
                      .on = on,
                      .tick = now.tick,
                      .offset_s = age,
                      .position = position});
  };
  for (const auto& [time, track, on] : now.switches.edges())
    note(wire::EventKind::track, static_cast<std::uint32_t>(track), on, dt - time,
         between(end_of(before, of), end_of(now, of), time, dt));
  for (const auto& [time, on, position] : now.compare.edges())
    note(wire::EventKind::compare, 1, on, dt - time, position);
  for (const Capture& c : now.probe.captures())
    note(wire::EventKind::probe, c.input, c.rising, c.age, c.position());
  for (const ProfileEvent& e : now.profile.events())
    note(e.kind == ProfileEvent::Kind::begin ? wire::EventKind::table_begin
                                             : wire::EventKind::end_of_profile,
         static_cast<std::uint32_t>(std::clamp<std::int64_t>(e.number, 1, most_number)), true,
         std::max(0.0, -e.t), e.master);
  const RegistrationReading& was = before.registration;
  const RegistrationReading& is = now.registration;
  const auto marks = [&](wire::MarkEvent what, std::int64_t count, double position) {
    for (; count > 0; --count)
      note(wire::EventKind::mark, static_cast<std::uint32_t>(what), true, 0, position);
  };
  marks(wire::MarkEvent::accepted, std::min<std::int64_t>(is.marks - was.marks, 1), is.deviation);
  marks(wire::MarkEvent::missing, std::min<std::int64_t>(is.missed - was.missed, most_marks), 0);
  marks(wire::MarkEvent::stray, std::min<std::int64_t>(is.strays - was.strays, most_marks), 0);
  marks(wire::MarkEvent::lost, is.lost && !was.lost ? 1 : 0, 0);
  std::stable_sort(events.begin(), events.end(),
                   [](const auto& a, const auto& b) { return a.offset_s > b.offset_s; });
  for (wire::Event& event : events) event.count = ++last_count;
  return events;
}

}  // namespace jounce
