// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "jounce/profiles/error.hpp"

#include "executor/src/record/record_wire.hpp"

// The program of a group: its timing law in parts, and the limits of its axes.

namespace jounce {
namespace {

constexpr std::size_t stretches_an_event = 32;
constexpr std::int64_t most_stretches = 1'000'000'000;

}  // namespace

std::vector<RecordedProgram> recorded(const GroupProgram& program, std::size_t axis,
                                      std::uint64_t id) {
  const std::vector<LawInterval> stretches = program.plan->law().stretches().unpacked();
  const std::span<const LawInterval> law = stretches;
  std::vector<RecordedProgram> parts;
  for (std::size_t first = 0; first < law.size(); first += stretches_an_event) {
    const auto some = law.subspan(first, std::min(stretches_an_event, law.size() - first));
    parts.push_back({.axis = axis,
                     .id = id,
                     .total = law.size(),
                     .first = first,
                     .law = {some.begin(), some.end()},
                     .axes = program.axes});
  }
  return parts;
}

std::vector<RecordedPathSwitches> recorded_switches(const GroupProgram& program, std::size_t axis,
                                                    std::uint64_t id) {
  constexpr std::size_t most = RecordedPathSwitches::most;
  const std::span<const PathSwitch> all = program.switches;
  std::vector<RecordedPathSwitches> parts;
  for (std::size_t first = 0; first < all.size(); first += most) {
    const auto some = all.subspan(first, std::min(most, all.size() - first));
    parts.push_back({.axis = axis, .id = id, .some = {some.begin(), some.end()}});
  }
  return parts;
}

GroupProgram remade(const std::vector<LawInterval>& law, std::vector<GroupAxis> axes) {
  if (law.empty() || axes.empty()) throw InputError("program", "", "has no law or no axes");
  const std::size_t n = axes.size();
  const double length = law.back().start + law.back().length;
  std::vector<double> line(2 * n, 0.0);  // from 0 by the length along the first axis
  line[n] = length;
  const PathPiece piece{.length = length > 0 ? length : 1};  // 0: the group rests
  Plan plan(Path(n, {piece}, std::move(line)), TimingLaw(law), {}, 0,
            {.limits = {}, .settings = {}});
  return {std::make_shared<const Plan>(std::move(plan)), std::move(axes)};
}

namespace record_wire {
namespace {

/// The numbers of a stretch in the order of program_t.
template <class S>
auto numbers_of(S& s) {
  return std::array{&s.time, &s.start,        &s.length,       &s.v0,   &s.peak,
                    &s.v1,   &s.acceleration, &s.deceleration, &s.jerk, &s.duration};
}

}  // namespace

program_t on_wire(const RecordedProgram& p) {
  program_t w{};
  w.axis = static_cast<std::int16_t>(p.axis);
  w.id = static_cast<std::int64_t>(p.id);
  w.total = static_cast<std::int64_t>(p.total);
  w.first = static_cast<std::int64_t>(p.first);
  w.count = static_cast<std::int32_t>(p.law.size());
  for (std::size_t i = 0; i < p.law.size(); ++i) {
    const auto numbers = numbers_of(p.law[i]);
    for (std::size_t k = 0; k < numbers.size(); ++k) w.value[i][k] = *numbers[k];
    w.value[i][numbers.size()] = p.law[i].pieces;
    w.single_phase[i] = p.law[i].is_phase() ? 1 : 0;
  }
  w.axes = static_cast<std::int32_t>(p.axes.size());
  for (std::size_t k = 0; k < p.axes.size(); ++k) {
    const auto& [config, peaks] = p.axes[k];
    w.period = config.period;
    const std::array<double, 8> limit{*config.limits.velocity,
                                      *config.limits.acceleration,
                                      config.limits.jerk.value_or(0),
                                      config.stop_acceleration,
                                      config.stop_jerk,
                                      peaks.velocity,
                                      peaks.acceleration,
                                      peaks.jerk};
    std::copy(limit.begin(), limit.end(), w.limit[k]);
  }
  return w;
}

RecordedProgram ours(const program_t& w) {
  if (w.count < 1 || w.count > static_cast<int>(stretches_an_event) || w.first < 0 ||
      w.total < w.first + w.count || w.total > most_stretches)
    throw InputError("count", std::to_string(w.first) + " and " + std::to_string(w.count),
                     "is not a part of a law of " + std::to_string(w.total) + " stretches");
  if (w.axes < 1 || w.axes > static_cast<int>(max_axes))
    throw InputError("axes", std::to_string(w.axes), "must be 1 to 9");
  RecordedProgram p{.axis = static_cast<std::size_t>(w.axis),
                    .id = static_cast<std::uint64_t>(w.id),
                    .total = static_cast<std::size_t>(w.total),
                    .first = static_cast<std::size_t>(w.first)};
  for (int i = 0; i < w.count; ++i) {
    LawInterval s;
    const auto numbers = numbers_of(s);
    for (std::size_t k = 0; k < numbers.size(); ++k) *numbers[k] = w.value[i][k];
    s.pieces = w.value[i][numbers.size()] > 0 ? 1 : 0;  // one straight piece; 0: a rest
    if (w.single_phase[i] != 0) s.deceleration = 0;     // older recordings have others
    p.law.push_back(s);
  }
  for (int k = 0; k < w.axes; ++k) {
    const auto& v = w.limit[k];
    GroupAxis axis;
    axis.config.period = w.period;
    axis.config.limits = {.velocity = v[0], .acceleration = v[1]};
    if (v[2] > 0) axis.config.limits.jerk = v[2];
    axis.config.stop_acceleration = v[3];
    axis.config.stop_jerk = v[4];
    axis.peaks = {.velocity = v[5], .acceleration = v[6], .jerk = v[7]};
    p.axes.push_back(axis);
  }
  return p;
}

path_switches_t on_wire(const RecordedPathSwitches& s) {
  path_switches_t w{};
  w.axis = static_cast<std::int16_t>(s.axis);
  w.id = static_cast<std::int64_t>(s.id);
  w.count = static_cast<std::int32_t>(s.some.size());
  for (std::size_t k = 0; k < s.some.size(); ++k) {
    w.time[k] = s.some[k].time;
    w.output[k] = static_cast<std::int8_t>(s.some[k].output);
    w.on[k] = s.some[k].on ? 1 : 0;
  }
  return w;
}

RecordedPathSwitches ours(const path_switches_t& w) {
  if (w.count < 1 || w.count > static_cast<int>(RecordedPathSwitches::most))
    throw InputError("count", std::to_string(w.count), "must be from 1 to 32");
  RecordedPathSwitches s{.axis = static_cast<std::size_t>(w.axis),
                         .id = static_cast<std::uint64_t>(w.id)};
  for (int k = 0; k < w.count; ++k) {
    if (w.output[k] < 1 || w.output[k] > 32)
      throw InputError("output", std::to_string(w.output[k]), "must be from 1 to 32");
    s.some.push_back({w.time[k], w.output[k], w.on[k] != 0});
  }
  return s;
}

}  // namespace record_wire
}  // namespace jounce
