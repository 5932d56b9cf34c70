#include "jounce/executor/events.hpp"

namespace jounce {
namespace {

/// One end of a step: position and velocity of what the switches are of.
struct End {
  double position = 0;
  double velocity = 0;
};

End end_of(const Tick& tick, SwitchesOf of) {
  if (of == SwitchesOf::master) return {tick.master, tick.master_velocity};
  return {tick.position, tick.velocity};
}

/// The cubic through both ends, t seconds after the first of dt.
double between(const End& a, const End& b, double t, double dt) {
  const double s = t / dt;
  const double way = b.position - a.position;
  const double bend = (1 - s) * (a.velocity * dt - way) - s * (b.velocity * dt - way);
  return a.position + s * way + s * (1 - s) * bend;
}

}  // namespace

std::vector<wire::Event> events_of(const Tick& before, const Tick& now, SwitchesOf of,
                                   std::int64_t period, std::int64_t last_count) {
  std::vector<wire::Event> events;
  const double dt = static_cast<double>((now.skipped + 1) * period) * 1e-9;
  for (const auto& [time, track, on] : now.switches.edges())
    events.push_back({.count = ++last_count,
                      .kind = wire::EventKind::track,
                      .number = static_cast<std::uint32_t>(track),
                      .on = on,
                      .tick = now.tick,
                      .offset_s = dt - time,
                      .position = between(end_of(before, of), end_of(now, of), time, dt)});
  return events;
}

}  // namespace jounce
