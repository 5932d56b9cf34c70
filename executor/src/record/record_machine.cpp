// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>

#include "jounce/profiles/error.hpp"

#include "executor/src/record/record_wire.hpp"

// The configuration and the cycles of a machine: axes with their outputs, masters, and every cycle.

namespace jounce::record_wire {

namespace {

/// f(name, ours, theirs) for every number.
template <class Ours, class Theirs, class F>
void each_of_output(Ours& o, Theirs& w, F f) {
  f("part", o.part, w.part);
  f("of", o.of, w.of);
  f("period", o.period, w.period);
  f("first_on_position", o.cam_switch.first_on_position, w.first_on_position);
  f("last_on_position", o.cam_switch.last_on_position, w.last_on_position);
  f("axis_direction", o.cam_switch.axis_direction, w.axis_direction);
  f("switch_mode", o.cam_switch.mode, w.switch_mode);
  f("duration", o.cam_switch.duration, w.duration);
  f("on_compensation", o.track.on_compensation, w.on_compensation);
  f("off_compensation", o.track.off_compensation, w.off_compensation);
  f("hysteresis", o.track.hysteresis, w.hysteresis);
  f("inverted", o.track.inverted, w.inverted);
  f("enabled", o.track.enabled, w.enabled);
  f("initial", o.track.initial, w.initial);
  f("compare_mode", o.mode, w.compare_mode);
  f("pulse", o.pulse, w.pulse);
  f("points", o.points, w.points);
}

/// home_distance of an axis_t without a limit.
constexpr double not_limited = 0;

}  // namespace

axis_t on_wire(const RecordedAxis& a) {
  axis_t w{};
  w.version = version;
  w.axis = static_cast<std::int16_t>(a.axis);
  put_text(a.name, w.name);
  put_text(a.units.position, w.position_unit);
  put_text(a.units.x, w.master_unit);
  w.whole = a.whole ? 1 : 0;
  w.switches = a.switches ? 1 : 0;
  each_number(a.config, w, Put{});
  w.home_distance = a.config.homing.distance.value_or(not_limited);
  return w;
}

RecordedAxis ours(const axis_t& w) {
  if (w.version != version)
    throw InputError("version", std::to_string(w.version),
                     "must be 7: replay the record with the version of jounce that wrote it");
  RecordedAxis a{.axis = static_cast<std::size_t>(w.axis),
                 .name = get_text(w.name),
                 .units = {get_text(w.master_unit), get_text(w.position_unit)},
                 .whole = w.whole != 0,
                 .switches = w.switches != 0};
  each_number(a.config, w, Get{});
  if (w.home_distance != not_limited) a.config.homing.distance = w.home_distance;
  return a;
}

cycle_t on_wire(const RecordedCycle& c) {
  cycle_t w{};
  w.axis = static_cast<std::int16_t>(c.axis);
  const Refusals refusals(c.tick);
  const CommandFields command = fields_of(c.command);
  each_command(command, w, Put{});
  each_input(c, w, Put{});
  each_output(c.tick, refusals, w, Put{});
  return w;
}

RecordedCycle ours(const cycle_t& w) {
  RecordedCycle c{.axis = static_cast<std::size_t>(w.axis)};
  Refusals refusals;
  CommandFields command;
  each_command(command, w, Get{});
  c.command = command_of(command);
  each_input(c, w, Get{});
  each_output(c.tick, refusals, w, Get{});
  refusals.put_into(c.tick);
  return c;
}

lost_t on_wire(const RecordedLoss& l) {
  lost_t w{};
  w.cycles = l.cycles;
  return w;
}

RecordedLoss ours(const lost_t& w) {
  return {w.cycles};
}

check_t on_wire(const RecordedCheck& c) {
  check_t w{};
  std::copy(c.hash.begin(), c.hash.end(), w.hash);
  return w;
}

RecordedCheck ours(const check_t& w) {
  RecordedCheck c;
  std::copy(std::begin(w.hash), std::end(w.hash), c.hash.begin());
  return c;
}

master_t on_wire(const RecordedMaster& m) {
  master_t w{};
  w.master = static_cast<std::int16_t>(m.master);
  put_text(m.name, w.name);
  put_text(m.unit, w.unit);
  w.followers = static_cast<std::int64_t>(m.followers);
  each_of_master(m, w, Put{});
  return w;
}

RecordedMaster ours(const master_t& w) {
  RecordedMaster m{.master = static_cast<std::size_t>(w.master),
                   .name = get_text(w.name),
                   .unit = get_text(w.unit),
                   .followers = static_cast<std::uint64_t>(w.followers)};
  each_of_master(m, w, Get{});
  return m;
}

sample_t on_wire(const RecordedSample& s) {
  sample_t w{};
  w.master = static_cast<std::int16_t>(s.master);
  each_of_sample(s.sample, w, Put{});
  return w;
}

RecordedSample ours(const sample_t& w) {
  RecordedSample s{.master = static_cast<std::size_t>(w.master)};
  each_of_sample(s.sample, w, Get{});
  return s;
}

sight_t on_wire(const RecordedSight& s) {
  sight_t w{};
  w.master = static_cast<std::int16_t>(s.master);
  w.tick = s.sight.tick;
  std::copy(s.sight.at.begin(), s.sight.at.end(), w.at);
  w.age = s.sight.age;
  return w;
}

RecordedSight ours(const sight_t& w) {
  RecordedSight s{.master = static_cast<std::size_t>(w.master),
                  .sight = {.tick = w.tick, .age = w.age}};
  std::copy(std::begin(w.at), std::end(w.at), s.sight.at.begin());
  return s;
}

output_t on_wire(const RecordedOutput& o) {
  output_t w{};
  w.axis = static_cast<std::int16_t>(o.axis);
  each_of_output(o, w, Put{});
  const bool track = o.part == RecordedOutput::Part::track;
  w.track = static_cast<std::int8_t>(track ? o.track.track : o.cam_switch.track);
  w.count = static_cast<std::int32_t>(o.some.size());
  for (std::size_t i = 0; i < o.some.size(); ++i) {
    w.position[i] = o.some[i].position;
    w.level[i] = o.some[i].level ? 1 : 0;
  }
  return w;
}

RecordedOutput ours(const output_t& w) {
  RecordedOutput o{.axis = static_cast<std::size_t>(w.axis)};
  each_of_output(o, w, Get{});
  o.cam_switch.track = o.track.track = w.track;
  if (w.points < 0 || w.points > static_cast<std::int64_t>(RecordedOutput::longest))
    throw InputError("points", std::to_string(w.points), "must be from 0 to 100000");
  if (w.compare_mode == 0) throw InputError("compare_mode", "0", "must be from 1 to 6");
  if (w.count < 0 || w.count > static_cast<int>(RecordedOutput::most_points))
    throw InputError("count", std::to_string(w.count), "must be from 0 to 64 points");
  for (int i = 0; i < w.count; ++i) o.some.push_back({w.position[i], w.level[i] != 0});
  return o;
}

}  // namespace jounce::record_wire
