// SPDX-License-Identifier: Apache-2.0
#include "axis/src/group/path_outputs.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace jounce {
namespace {

/// Path time at the share x of a tick: the cubic through path time and rate at both ends.
double path_time_at(double x, const PathTime& before, const PathTime& now, double dt) {
  const double way = now.s - before.s;
  const double bend = (1 - x) * (before.rate * dt - way) - x * (now.rate * dt - way);
  return before.s + x * way + x * (1 - x) * bend;
}

/// The instant at which the path reaches the path time s, after the previous tick.
double instant_of(double s, const PathTime& before, const PathTime& now, double dt) {
  if (before.rate == now.rate && now.rate > 0) return (s - before.s) / now.rate;
  constexpr int bits_of_a_double = 53;
  double low = 0;
  double high = 1;
  for (int i = 0; i < bits_of_a_double; ++i) {
    const double middle = (low + high) / 2;
    (path_time_at(middle, before, now, dt) < s ? low : high) = middle;
  }
  return high * dt;
}

}  // namespace

void PathOutputs::pass(const Movement& path, const PathTime& now, double dt) noexcept {
  const bool begins = path.id() != path_;
  path_ = path.id();
  if (begins) before_ = {.s = 0, .rate = now.rate};
  for (const PathSwitch& what : path.switches(before_.s, now.s)) {
    // The path may have begun between both ticks.
    const double time = begins && now.rate > 0 ? dt - (now.s - what.time) / now.rate
                                               : instant_of(what.time, before_, now, dt);
    set(what, std::clamp(time, 0.0, std::nextafter(dt, 0.0)));
  }
  before_ = now;
}

void PathOutputs::continue_as(const Movement& path, double shift) noexcept {
  path_ = path.id();
  before_.s -= shift;
}

void PathOutputs::set(const PathSwitch& what, double time) noexcept {
  const std::uint32_t bit = 1U << static_cast<unsigned>(what.output - 1);
  if (((edges_.outputs & bit) != 0) == what.on) return;
  edges_.outputs ^= bit;
  if (edges_.count < SwitchStep::most_edges)
    edges_.edge[edges_.count++] = {time, what.output, what.on};
  else
    ++edges_.lost;
}

void PathOutputs::off() noexcept {
  while (edges_.outputs != 0) set({.output = std::countr_zero(edges_.outputs) + 1, .on = false}, 0);
}

void PathOutputs::add_to(SwitchStep& step) const noexcept {
  if (edges_.outputs == 0 && edges_.count == 0) return;
  step.outputs |= edges_.outputs;
  step.lost += edges_.lost;
  for (const SwitchEdge& edge : edges_.edges()) {
    if (step.count == SwitchStep::most_edges) {
      ++step.lost;
      continue;
    }
    std::uint32_t place = step.count++;
    for (; place > 0 && step.edge[place - 1].time > edge.time; --place)
      step.edge[place] = step.edge[place - 1];
    step.edge[place] = edge;
  }
}

}  // namespace jounce
