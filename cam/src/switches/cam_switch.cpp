// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/switches/cam_switch.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "jounce/profiles/detail/six_digits.hpp"
#include "jounce/profiles/error.hpp"

#include "cam/src/switches/switch_machine.hpp"

namespace jounce {
namespace {

/// Throws for one entry of a list: "switch[2].duration = 0: must be greater than 0".
struct Entry {
  std::string key;

  [[noreturn]] void fail(const char* member, double value, const std::string& rule) const {
    throw InputError(key + "." + member, value, rule);
  }
  void finite(const char* member, double value) const {
    require_finite((key + "." + member).c_str(), value);
  }
  void track(int value) const {
    if (value < 1 || value > CamSwitchSpec::most_tracks) fail("track", value, "must be 1 to 32");
  }
};

Entry entry(const char* list, std::size_t index) {
  return {std::string(list) + "[" + std::to_string(index + 1) + "]"};
}

void require_track(const CamSwitchSpec& spec, std::size_t i) {
  const Entry at = entry("track", i);
  const SwitchTrack& t = spec.tracks[i];
  at.track(t.track);
  at.finite("on_compensation", t.on_compensation);
  at.finite("off_compensation", t.off_compensation);
  require_not_negative((at.key + ".hysteresis").c_str(), t.hysteresis);
  const auto same = [&](const auto& other) { return other.track == t.track; };
  if (std::any_of(spec.tracks.begin(), spec.tracks.begin() + static_cast<std::ptrdiff_t>(i), same))
    at.fail("track", t.track, "has two sets of options: keep one");
  if (std::none_of(spec.switches.begin(), spec.switches.end(), same))
    at.fail("track", t.track, "has options but no switch: add a [[switch]] with this track");
}

/// Checks the width of the range, and the gap that a rotary axis leaves.
void require_range(const CamSwitch& s, const Entry& at, double hysteresis, double period) {
  if (!s.last_on_position)
    throw InputError(
        at.key + ".last_on_position", "",
        "is missing: a switch in position mode is on from first_on_position to last_on_position");
  const double last = *s.last_on_position;
  at.finite("last_on_position", last);
  const double difference = last - s.first_on_position;
  const double width = difference < 0 ? difference + period : difference;
  if (period == 0 && difference < 0)
    at.fail("last_on_position", last,
            "must be above first_on_position = " + number(s.first_on_position) +
                ": only a rotary axis has ranges across its period. Invert the track for an output "
                "that is on outside the range");
  if (!(width > 0) || (period > 0 && width > period))
    at.fail("last_on_position", last,
            period > 0 ? "must be from " + number(s.first_on_position - period) + " to " +
                             number(s.first_on_position + period) +
                             ", within one period of first_on_position, and not equal to it"
                       : "must be above first_on_position = " + number(s.first_on_position));
  if (!(hysteresis < width))
    at.fail("last_on_position", last,
            "the range must be wider than the hysteresis of its track, " + number(hysteresis));
  if (period > 0 && width < period && !(hysteresis < period - width))
    at.fail("last_on_position", last,
            "the rest of the period must be wider than the hysteresis of its track, " +
                number(hysteresis));
}

void require_duration(const CamSwitch& s, const Entry& at, const SwitchTrack& track) {
  const double duration = *s.duration;
  if (!(duration > 0) || !std::isfinite(duration))
    at.fail("duration", duration, "must be greater than 0");
  if (!(duration + track.off_compensation - track.on_compensation > 0))
    at.fail("duration", duration,
            "must be longer: with the compensations of its track it is " +
                six_digits(duration + track.off_compensation - track.on_compensation));
}

void require_switch(const CamSwitchSpec& spec, std::size_t i) {
  const Entry at = entry("switch", i);
  const CamSwitch& s = spec.switches[i];
  const SwitchTrack track = spec.options(s.track);
  const double period = spec.period.value_or(0);
  at.track(s.track);
  at.finite("first_on_position", s.first_on_position);
  if (period > 0 && !(2 * track.hysteresis < period))
    at.fail("track", s.track,
            "the hysteresis of this track must be less than half the period, " +
                six_digits(period / 2));
  if (s.mode == CamSwitchMode::position) {
    if (s.duration)
      at.fail("duration", *s.duration,
              s.last_on_position ? "contradicts last_on_position: leave one of them out"
                                 : "applies to mode = \"time\" only: choose this mode, or give "
                                   "last_on_position instead");
    return require_range(s, at, track.hysteresis, period);
  }
  if (s.last_on_position)
    at.fail("last_on_position", *s.last_on_position,
            s.duration ? "contradicts duration in mode = \"time\": leave one of them out"
                       : "applies to mode = \"position\" only: choose this mode, or give duration "
                         "instead");
  if (!s.duration)
    throw InputError(at.key + ".duration", "",
                     "is missing: a switch in time mode needs a duration");
  require_duration(s, at, track);
}

}  // namespace

SwitchTrack CamSwitchSpec::options(int track) const {
  for (const SwitchTrack& t : tracks)
    if (t.track == track) return t;
  return {.track = track};
}

void require_valid(const CamSwitchSpec& spec) {
  if (spec.period) require_positive("period", *spec.period);
  for (std::size_t i = 0; i < spec.tracks.size(); ++i) require_track(spec, i);
  for (std::size_t i = 0; i < spec.switches.size(); ++i) require_switch(spec, i);
}

SwitchTimes switch_times(const CamSwitchSpec& spec, const Trajectory& position) {
  require_valid(spec);
  cam_detail::SwitchMachine machine(spec);
  const Jet first = position.jet(position.start());
  machine.place(first[0], first[1]);
  SwitchTimes times{.outputs = machine.settle(), .edges = {}};
  for (std::size_t i = 0; i < position.segments().size(); ++i) {
    machine.begin(position.segments()[i]);
    while (auto edge = machine.next()) {
      edge->time += position.breaks()[i];
      times.edges.push_back(*edge);
    }
  }
  return times;
}

const char* name(AxisDirection direction) {
  switch (direction) {
    case AxisDirection::both:
      return "both";
    case AxisDirection::positive:
      return "positive";
    case AxisDirection::negative:
      break;
  }
  return "negative";
}

const char* name(CamSwitchMode mode) {
  return mode == CamSwitchMode::position ? "position" : "time";
}

}  // namespace jounce
