// SPDX-License-Identifier: Apache-2.0
#include "cam/src/switches/switch_machine.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace jounce::cam_detail {
namespace {

constexpr std::uint32_t bit(int track) {
  return 1U << static_cast<unsigned>(track - 1);
}

}  // namespace

// ---- a boundary --------------------------------------------------------------------------------
//
// The boundaries p_k = p + k P divide the axis into intervals; `passed` = k means that the axis is
// between p_k and p_k+1. Without a lock, p_k <= y <= p_k+1. (1)
// With a lock at p_m, |y - p_m| <= h and k is m or m - 1, for either side. (2)
// Touching a boundary does not pass it: both ends of (1) are closed.

void Boundary::place(double y) {
  locked = false;
  passed = period > 0 ? static_cast<std::int64_t>(std::floor((y - position) / period))
                      : (y > position ? 0 : -1);
}

double Boundary::target(bool up) const {
  if (locked) return at(lock) + (up ? hysteresis : -hysteresis);
  if (period > 0) return at(up ? passed + 1 : passed);
  if (up) return passed < 0 ? position : never;
  return passed < 0 ? -never : position;
}

int Boundary::pass(bool up) {
  const std::int64_t before = passed;
  if (locked) {  // from (2) to (1): adds the missing edge if the axis leaves on the other side
    passed = up ? lock : lock - 1;
    locked = false;
  } else {
    lock = up ? passed + 1 : passed;
    passed += up ? 1 : -1;
    locked = hysteresis > 0;
  }
  return static_cast<int>(passed - before);
}

// ---- a heading ---------------------------------------------------------------------------------

void Heading::place(double x, double velocity) {
  sign = hysteresis == 0 ? (velocity > 0) - (velocity < 0) : 0;
  low = high = x;
}

double Heading::target(bool up) const {
  if (up) return sign <= 0 ? low + hysteresis : never;
  return sign >= 0 ? high - hysteresis : -never;
}

void Heading::follow(const MonotonePart& done) {
  low = std::min(low, done.to);
  high = std::max(high, done.to);
}

void Heading::turn(bool up) {
  (up ? high : low) = target(up);
  sign = up ? 1 : -1;
}

// ---- setup -------------------------------------------------------------------------------------

SwitchMachine::SwitchMachine(const CamSwitchSpec& spec) : period_(spec.period.value_or(0)) {
  path(0, 0);
  for (const CamSwitch& s : spec.switches) add(s, spec);
  for (const Track& t : tracks_) {
    if (!t.options.enabled) continue;
    enabled_ |= bit(t.options.track);
    if (t.options.initial) outputs_ |= bit(t.options.track);
  }
}

std::size_t SwitchMachine::path(double forwards, double backwards) {
  for (std::size_t i = 0; i < paths_.size(); ++i)
    if (paths_[i].forwards() == forwards && paths_[i].backwards() == backwards) return i;
  paths_.emplace_back(forwards, backwards);
  return paths_.size() - 1;
}

std::size_t SwitchMachine::track(const SwitchTrack& options) {
  for (std::size_t i = 0; i < tracks_.size(); ++i)
    if (tracks_[i].options.track == options.track) return i;
  tracks_.push_back({options});
  tracks_.back().heading.hysteresis = options.hysteresis;
  return tracks_.size() - 1;
}

/// Extends the range by `near`, so that an axis at rest on a boundary is within it.
void SwitchMachine::add(const CamSwitch& s, const CamSwitchSpec& spec) {
  const SwitchTrack options = spec.options(s.track);
  const double on = options.on_compensation;
  const double off = options.off_compensation;
  const double first = s.first_on_position;
  double last = s.last_on_position.value_or(first);
  if (last < first) last += period_;
  const double near = 1e-12 * std::max({std::abs(first), std::abs(last), period_});

  Switch made{.track = track(options), .direction = s.axis_direction};
  for (Boundary* b : {&made.lower, &made.upper}) {
    b->period = period_;
    b->hysteresis = options.hysteresis;
  }
  made.lower.position = first - near;
  made.upper.position = last + near;
  if (s.mode == CamSwitchMode::time) {
    made.pulse = *s.duration + off - on;
    made.lower.path = path(on, on);
  } else {
    made.lower.path = path(on, off);  // switches on forwards, off backwards
    made.upper.path = path(off, on);
  }
  switches_.push_back(made);
}

void SwitchMachine::place(double x, double velocity) {
  for (SwitchPath& p : paths_) p.place(x, velocity);
  for (Track& t : tracks_) t.heading.place(x, velocity);
  for (Switch& s : switches_) {
    s.lower.place(paths_[s.lower.path].last());
    s.upper.place(paths_[s.upper.path].last());
  }
}

void SwitchMachine::shift(std::int64_t periods) {
  if (periods == 0) return;
  const double distance = static_cast<double>(periods) * period_;
  for (SwitchPath& p : paths_) p.shift(distance);
  for (Track& t : tracks_) {
    t.heading.low -= distance;
    t.heading.high -= distance;
  }
  for (Switch& s : switches_)
    for (Boundary* b : {&s.lower, &s.upper}) {
      b->passed -= periods;
      b->lock -= periods;
    }
}

// ---- events ------------------------------------------------------------------------------------

void SwitchMachine::begin(const Segment& motion) {
  piece_.set(motion);
  for (SwitchPath& p : paths_) p.begin(piece_);
  now_ = 0;
  length_ = motion.length;
  const auto restart = [this](auto& event) {
    event.part = 0;
    seek(event);
  };
  for (Track& t : tracks_) restart(t.heading);
  for (Switch& s : switches_) {
    restart(s.lower);
    if (s.pulse == 0) restart(s.upper);
  }
}

void SwitchMachine::wait(double length) {
  now_ = 0;
  length_ = length;
  for (Track& t : tracks_) t.heading.next = never;
  for (Switch& s : switches_) s.lower.next = s.upper.next = never;
}

/// The event's next time, at which its path passes the target. Skips intervals that do not reach
/// it.
template <class Source>
void SwitchMachine::seek(Source& source) const {
  const SwitchPath& p = paths_[source.path];
  for (; source.part < p.parts().size(); ++source.part) {
    const MonotonePart& part = p.parts()[source.part];
    source.rising = part.to > part.from;
    const double target = source.target(source.rising);
    if (source.rising ? part.to > target : part.to < target) {
      source.next = p.time(part, target);
      return;
    }
    source.follow(part);
  }
  source.next = never;
}

double SwitchMachine::earliest() const {
  double time = never;
  for (const Track& t : tracks_) time = std::min(time, t.heading.next);
  for (const Switch& s : switches_) time = std::min({time, s.lower.next, s.upper.next, s.off});
  return time;
}

/// Processes all events up to now_.
void SwitchMachine::happen() {
  for (Track& t : tracks_)
    while (t.heading.next <= now_) {
      t.heading.turn(t.heading.rising);
      seek(t.heading);
    }
  for (Switch& s : switches_) happen(s);
}

void SwitchMachine::happen(Switch& s) {
  if (s.off <= now_) s.off = never;
  for (; s.upper.next <= now_; seek(s.upper)) s.upper.pass(s.upper.rising);
  for (; s.lower.next <= now_; seek(s.lower)) {
    const int change = s.lower.pass(s.lower.rising);
    const bool asked = s.direction == AxisDirection::both ||
                       (change > 0) == (s.direction == AxisDirection::positive);
    if (s.pulse > 0 && change != 0 && asked) s.off = now_ + s.pulse;
  }
}

std::optional<SwitchEdge> SwitchMachine::next() {
  for (;;) {
    if (const std::uint32_t changed = wanted() ^ outputs_; changed != 0) {
      const int track = std::countr_zero(changed) + 1;
      outputs_ ^= bit(track);
      return SwitchEdge{now_, track, (outputs_ & bit(track)) != 0};
    }
    const double time = earliest();
    if (time > length_) break;
    now_ = std::max(now_, time);
    happen();
  }
  for (Switch& s : switches_) s.off -= length_;
  return std::nullopt;
}

/// The outputs that are required now.
std::uint32_t SwitchMachine::wanted() const {
  std::uint32_t on = 0;
  std::uint32_t unknown = 0;
  for (const Switch& s : switches_) {
    const Track& t = tracks_[s.track];
    if (s.pulse > 0 ? s.off == never : s.lower.passed <= s.upper.passed) continue;
    const int asked = s.direction == AxisDirection::positive ? 1 : -1;
    if (s.pulse > 0 || s.direction == AxisDirection::both || t.heading.sign == asked)
      on |= bit(t.options.track);
    else if (t.heading.sign == 0)
      unknown |= bit(t.options.track);
  }
  std::uint32_t outputs = 0;
  for (const auto& [options, heading] : tracks_) {
    const std::uint32_t b = bit(options.track);
    const bool known = (on & b) != 0 || (unknown & b) == 0;
    if (known ? ((on & b) != 0) != options.inverted : options.initial) outputs |= b;
  }
  return outputs & enabled_;
}

}  // namespace jounce::cam_detail
